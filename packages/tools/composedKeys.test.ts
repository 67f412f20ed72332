import { expect, it } from 'vitest';
import { uncheckedKeys } from './composedKeys.mjs';
import { sourceFiles } from './sourceFiles.mjs';

it("text fields leave an input method's Enter and Escape alone", () => {
  const found = [...sourceFiles()].flatMap(([path, source]) =>
    /^(packages|apps)\/[\w-]+\/src\/.*\.tsx?$/.test(path) && !/\.test\.tsx?$/.test(path)
      ? uncheckedKeys(path, source)
      : [],
  );
  expect(found).toEqual([]);
});

it.each([
  ["const f = <input onKeyDown={({ key }) => { if (key === 'Enter') end(); }} />;", ['X.tsx:1']],
  ["const f = <input onKeyDown={(e) => { if (isComposing(e)) return;\nif (e.key === 'Escape') end(); }} />;", []],
  ["const f = (e) => { isComposing(e); };\nconst g = (e) => e.key !== 'Enter' && <input />;", ['X.tsx:2']],
  ["const f = (e) => e.key === 'ArrowUp' && <input />;", []],
  ["addEventListener('keydown', ({ key }) => { if (key === 'Escape') cancel(); });", []],
])('%s', (source, found) => expect(uncheckedKeys('X.tsx', source)).toEqual(found));
