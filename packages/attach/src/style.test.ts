import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';

const tokensOf = (path: string): Map<string, string> => {
  const text = readFileSync(new URL(path, import.meta.url), 'utf8');
  return new Map([...text.matchAll(/^ {2}(--[\w-]+):\s*([^;]+);/gm)].map(([, name, value]) => [name, value]));
};

it("has the colours and measures of Farol's own editor", () => {
  const [own, ...theirs] = [
    'style.css',
    '../../../apps/editor/src/style/theme.css',
    '../../editing/src/appearance/colours.css',
  ].map(tokensOf);
  const editor = new Map(theirs.flatMap((tokens) => [...tokens]));
  expect(own.size).toBeGreaterThan(10);
  for (const [name, value] of own) expect(`${name}: ${value}`).toBe(`${name}: ${editor.get(name)}`);
});
