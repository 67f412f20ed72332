import { expect, it } from 'vitest';
import { coreViolations } from './coreChunk.mjs';
import { sourceFiles } from './sourceFiles.mjs';

const src = 'packages/renderer/src';

it('holds nothing that is fetched late', () => {
  expect(coreViolations(sourceFiles())).toEqual([]);
});

it.each([
  ["import { Draws } from './Draws';", "import { Maps } from './shadows/Maps';"],
  ["export { Draws } from './Draws';", "export { Maps } from './shadows/Maps';"],
  ["import { type Info, Draws } from './Draws';", "import { makeMaps } from './shadows';"],
])('says by which way late code comes into it: %s %s', (index, draws) => {
  const files = new Map([
    [`${src}/index.ts`, `${index} const late = () => import('./shadows');`],
    [`${src}/Draws.ts`, draws],
    [`${src}/shadows/index.ts`, "import { Maps } from './Maps'; import { Frame } from '../Frame';"],
    [`${src}/shadows/Maps.ts`, ''],
    [`${src}/Frame.ts`, ''],
  ]);
  const violations = coreViolations(files);
  expect(violations[0]).toContain(`${src}/index.ts -> ${src}/Draws.ts -> ${src}/shadows/`);
  expect(violations.join()).not.toContain('Frame.ts is');
});

it('lets the core import types, and late code the core', () => {
  const files = new Map([
    [
      `${src}/index.ts`,
      "import './Frame'; import type { Maps } from './shadows'; const late = () => import('./shadows');",
    ],
    [`${src}/shadows/index.ts`, "import { Maps } from './Maps'; import { Frame } from '../Frame';"],
    [`${src}/shadows/Maps.ts`, ''],
    [`${src}/Frame.ts`, "import type { Maps } from './shadows/Maps';"],
  ]);
  expect(coreViolations(files)).toEqual([]);
});
