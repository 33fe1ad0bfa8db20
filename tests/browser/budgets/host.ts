import { readFile } from "node:fs/promises";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { brotliCompress, gzip } from "node:zlib";

export const DIST = fileURLToPath(new URL("../../../web/page/dist", import.meta.url));
export type Encoding = "gzip" | "br";

const TYPES: Record<string, string> = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
  ".json": "application/json",
  ".webmanifest": "application/manifest+json",
  ".svg": "image/svg+xml",
  ".txt": "text/plain; charset=utf-8",
};
const compress = { gzip: promisify(gzip), br: promisify(brotliCompress) };

/** The built page on a static host that compresses what it sends, as public hosts do, and counts the bytes. */
export class Host {
  /** Bytes on the wire, header included, by path. */
  readonly sent = new Map<string, number>();
  readonly #server: Server;

  private constructor(encoding: Encoding) {
    this.#server = createServer((request, response) => {
      const path = new URL(request.url ?? "/", "http://host").pathname;
      const before = response.socket?.bytesWritten ?? 0;
      response.on("finish", () => this.sent.set(path, (request.socket.bytesWritten ?? 0) - before));
      void answer(path, encoding).then(
        ([headers, body]) => response.writeHead(200, headers).end(body),
        () => response.writeHead(404).end(),
      );
    });
  }

  static async start(encoding: Encoding): Promise<Host> {
    const host = new Host(encoding);
    await new Promise<void>((resolve) => host.#server.listen(0, "localhost", resolve));
    return host;
  }

  get address(): string {
    return `http://localhost:${(this.#server.address() as AddressInfo).port}/`;
  }

  stop(): void {
    this.#server.closeAllConnections();
    this.#server.close();
  }
}

const answers = new Map<string, Promise<[Record<string, string>, Buffer]>>();

/** Compressed once: a host keeps what it has compressed. */
function answer(path: string, encoding: Encoding): Promise<[Record<string, string>, Buffer]> {
  const key = `${encoding} ${path}`;
  const made = answers.get(key) ?? make(path, encoding);
  answers.set(key, made);
  return made;
}

async function make(path: string, encoding: Encoding): Promise<[Record<string, string>, Buffer]> {
  const file = path.endsWith("/") ? `${path}index.html` : path;
  const body = await compress[encoding](await readFile(join(DIST, normalize(file))));
  const headers = {
    "content-type": TYPES[extname(file)] ?? "application/octet-stream",
    "content-encoding": encoding,
    "cache-control": "max-age=600",
    vary: "accept-encoding",
  };
  return [headers, body];
}
