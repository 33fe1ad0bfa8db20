/** The scenario in the address: `#v1.<base64url(deflate(JSON))>`. Shape, version and sizes are checked before use. */
const VERSION = 1;
const SHAPE = /^#v(\d{1,6})\.([A-Za-z0-9_-]+)$/;
export const MAX_LINK_CHARACTERS = 8 * 1024;
export const MAX_INFLATED_BYTES = 64 * 1024;

/** Its message is a sentence for the student. */
export class LinkError extends Error {}

/** Throws where the link would be longer than what is read. */
export async function encodeLink(document: unknown): Promise<string> {
  const bytes = new TextEncoder().encode(JSON.stringify(document));
  const deflated = await collect(through(bytes, new CompressionStream("deflate")), Infinity);
  const hash = `#v${VERSION}.${toBase64Url(deflated)}`;
  if (hash.length > MAX_LINK_CHARACTERS)
    throw new LinkError(
      `A link to this scene would be ${hash.length} characters long; at most ${MAX_LINK_CHARACTERS} are read.`,
    );
  return hash;
}

/** The page's address with the document in it. Throws where that is too long. */
export async function addressOf(document: unknown): Promise<string> {
  return location.href.split("#")[0] + (await encodeLink(document));
}

/** The JSON document of a link. What it means is for the caller to validate. */
export async function decodeLink(hash: string): Promise<unknown> {
  if (hash.length > MAX_LINK_CHARACTERS)
    throw new LinkError(
      `This link is ${hash.length} characters long; at most ${MAX_LINK_CHARACTERS} are read.`,
    );
  const match = SHAPE.exec(hash);
  if (!match) throw new LinkError("This link does not have the form #v1.… of a scenario.");
  if (Number(match[1]) !== VERSION)
    throw new LinkError(`This link has version ${Number(match[1])}; this page reads version ${VERSION}.`);
  const inflated = await inflate(match[2]);
  try {
    return JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(inflated));
  } catch {
    throw new LinkError("This link unpacks to something that is not a scenario.");
  }
}

async function inflate(base64Url: string): Promise<Uint8Array> {
  try {
    const stream = through(fromBase64Url(base64Url), new DecompressionStream("deflate"));
    return await collect(stream, MAX_INFLATED_BYTES);
  } catch (error) {
    if (error instanceof LinkError) throw error;
    throw new LinkError("This link is damaged or was cut off: its contents do not unpack.", { cause: error });
  }
}

function through(bytes: Uint8Array<ArrayBuffer>, transform: CompressionStream | DecompressionStream) {
  return new Blob([bytes]).stream().pipeThrough(transform);
}

async function collect(stream: ReadableStream<Uint8Array>, limit: number): Promise<Uint8Array> {
  const chunks: Uint8Array[] = [];
  let length = 0;
  const reader = stream.getReader();
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    length += next.value.length;
    if (length > limit) {
      void reader.cancel().catch(() => undefined);
      throw new LinkError(`This link unpacks to more than ${limit} bytes; no scenario is that long.`);
    }
    chunks.push(next.value);
  }
  const all = new Uint8Array(length);
  let at = 0;
  for (const chunk of chunks) {
    all.set(chunk, at);
    at += chunk.length;
  }
  return all;
}

function toBase64Url(bytes: Uint8Array): string {
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

function fromBase64Url(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(binary, (character) => character.charCodeAt(0));
}
