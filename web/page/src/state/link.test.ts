import { describe, expect, test } from "vitest";
import { decodeLink, encodeLink, LinkError, MAX_INFLATED_BYTES, MAX_LINK_CHARACTERS } from "./link";

const scenario = {
  version: 1,
  name: "größer – 部屋",
  anchors: Array.from({ length: 12 }, (_, i) => [i / 3, -1 - i, Math.sqrt(i)]),
  seed: 2 ** 53,
};

describe("links", () => {
  test("come back as the same document, to the last bit of every number", async () => {
    expect(await decodeLink(await encodeLink(scenario))).toEqual(scenario);
  });

  test("hold twelve anchors in less than 2000 characters", async () => {
    expect((await encodeLink(scenario)).length).toBeLessThan(2000);
  });

  test.each([
    ["no link at all", "#hello", "form"],
    ["a character outside the alphabet", "#v1.ab+c", "form"],
    ["a newer version", "#v2.eJyrVgIAAP__", "version 2"],
    ["noise", "#v1.AAAAAAAA", "damaged"],
    ["a length that is no base64", "#v1.A", "damaged"],
    ["too many characters", `#v1.${"A".repeat(MAX_LINK_CHARACTERS)}`, "long"],
  ])("refuse %s in a sentence", async (_what, hash, word) => {
    await expect(decodeLink(hash)).rejects.toThrow(LinkError);
    await expect(decodeLink(hash)).rejects.toThrow(word);
  });

  test("refuse every link that was cut short", async () => {
    const whole = await encodeLink(scenario);
    for (let length = 4; length < whole.length; length += 17)
      await expect(decodeLink(whole.slice(0, length))).rejects.toThrow(LinkError);
  });

  test("are not made where they would not be read", async () => {
    const numbers = Array.from({ length: 3000 }, (_, i) => Math.sqrt(i));
    await expect(encodeLink({ numbers })).rejects.toThrow(
      /^A link to this scene would be \d+ characters long/,
    );
  });

  test("refuse a small link that unpacks to much", async () => {
    const bomb = await encodeLink({ name: "x".repeat(MAX_INFLATED_BYTES) });
    expect(bomb.length).toBeLessThan(MAX_LINK_CHARACTERS);
    await expect(decodeLink(bomb)).rejects.toThrow("unpacks to more than");
  });
});
