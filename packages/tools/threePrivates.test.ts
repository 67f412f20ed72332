import { expect, it } from 'vitest';
import { sourceFiles } from './sourceFiles.mjs';
import { privatesOfThree } from './threePrivates.mjs';

it('what three keeps private is used behind packages/renderer/src/three alone', () => {
  const found = [...sourceFiles()].flatMap(([path, source]) =>
    /^(packages|apps)\/[\w-]+\/src\//.test(path) && !/\.test\.tsx?$/.test(path) ? privatesOfThree(path, source) : [],
  );
  expect(found).toEqual([]);
});

it.each([
  ['webgl.properties.get(texture).__webglTexture', ['webgl.properties', '__webglTexture']],
  ['camera._reversedDepth = true;', ['._reversedDepth']],
  ['frame.webgl.state.viewport(v);', ['webgl.state']],
  ['const { state } = this.webgl;', ['{ state } = this.webgl']],
  ["// webgl.state\n/* __webglTexture */ const state = field.state; const url = 'https://a.org/b';", []],
])('%s', (source, found) => {
  const path = 'packages/renderer/src/frame/X.ts';
  expect(privatesOfThree(path, source)).toEqual(expect.arrayContaining(found.map((name) => `${path} uses ${name}`)));
  expect(privatesOfThree(path, source)).toHaveLength(found.length);
  expect(privatesOfThree('packages/renderer/src/three/X.ts', source)).toEqual([]);
});
