import { expect, test } from 'vitest';

const sources = import.meta.glob<string>(['./**/*.ts', '!./**/*.test.ts', '!./**/testing/**'], {
  query: '?raw',
  import: 'default',
  eager: true,
});

/** Names of the files in which a pattern is found, without folder and ending. */
function filesWith(pattern: RegExp): string[] {
  const found = Object.entries(sources).filter(([, source]) => pattern.test(source));
  return found.map(([path]) => path.slice(path.lastIndexOf('/') + 1, -'.ts'.length)).toSorted();
}

test.each([
  ['place', ['TextureAtlas']],
  ['release', ['TextureAtlas']],
  ['change', ['CookieSlot', 'ShadowMaps', 'ShadowSlot']],
  ['lose', ['LightSlots']],
  ['noteAge', ['ShadowMapDraws']],
  ['plan', ['PlannedDraws', 'ShadowSlot']],
  ['draw', ['CookieDraws', 'PlannedDraws']],
  ['bound', ['ShadowBounds']],
])('the step %s of a map is taken by %s alone, as README.md says', (step, files) => {
  expect(filesWith(new RegExp(`\\bmap\\.${step}\\(`))).toEqual(files);
});

test.each([
  ['where a map lies', 'placement\\.(take|drop|halve|restore)\\(', ['TextureAtlas']],
  ['the level of detail of a map', 'detail\\??\\.(start|aim|reach|settle)\\(', ['TextureAtlas', 'chooseDetail']],
  ['what the frame says of a light', '\\w+\\.(lastLit|coverage|casts|cookie) = ', ['LightSlots']],
  ['whether a light has a shadow', '\\w+\\.hasShadow = ', ['ShadowMaps']],
  ['which record a mask has', '\\w+\\.record = ', ['LightSlots', 'MaskRecords']],
  ['cameras and faces', 'this\\.(near|far|root|layers|drawnFaces) = ', ['ShadowSlot']],
])('%s is written in one place', (_, pattern, files) => {
  expect(filesWith(new RegExp(`\\b${pattern}`))).toEqual(files);
});
