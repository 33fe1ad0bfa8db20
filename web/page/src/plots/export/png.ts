/** Texts in a PNG file (tEXt chunks), so that a picture still says where it comes from. */

const SIGNATURE_LENGTH = 8;
/** Length, type and check sum around the data of a chunk. */
const FRAME_LENGTH = 12;

/** The same picture with the texts behind its header; keywords and texts are ASCII. */
export function withTexts(png: Uint8Array, texts: Record<string, string>): Uint8Array<ArrayBuffer> {
  const view = new DataView(png.buffer, png.byteOffset);
  const headerEnd = SIGNATURE_LENGTH + FRAME_LENGTH + view.getUint32(SIGNATURE_LENGTH);
  const chunks = Object.entries(texts).map(([keyword, text]) => textChunk(keyword, text));
  return concatenate([png.subarray(0, headerEnd), ...chunks, png.subarray(headerEnd)]);
}

function textChunk(keyword: string, text: string): Uint8Array {
  const content = new TextEncoder().encode(`tEXt${keyword}\0${text}`);
  const chunk = new Uint8Array(content.length + 8);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, content.length - 4);
  chunk.set(content, 4);
  view.setUint32(content.length + 4, checkSum(content));
  return chunk;
}

/** CRC-32 as in the PNG specification, appendix D. */
function checkSum(bytes: Uint8Array): number {
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; bit++) sum = sum & 1 ? (sum >>> 1) ^ 0xedb88320 : sum >>> 1;
  }
  return (sum ^ 0xffffffff) >>> 0;
}

function concatenate(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const whole = new Uint8Array(parts.reduce((length, part) => length + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
