import { describe, expect, it } from 'vitest';
import { formatMicroShader } from './formatMicroShader';
import { parseMicroShader } from './parseMicroShader';

const TEXT = `// Says what it is for.
// Farol
#include "common"
  #include "light"  // and why
#include <bsdfs>
uniform float a;
//# main
float b = a;
`;

describe('parseMicroShader', () => {
  it('splits header and main and takes the includes of ours, not of three, as dependencies', () => {
    const chunk = parseMicroShader('x', TEXT);
    expect(chunk.dependencies).toEqual(['common', 'light']);
    expect(chunk.main).toBe('float b = a;\n');
    expect(chunk.header.endsWith('uniform float a;\n')).toBe(true);
    expect(chunk.mainLine).toBe(8);
  });

  it('has no main part without the line, whatever the line ends', () => {
    expect(parseMicroShader('x', 'float a;\r\n// # main\r\n').main).toBe('');
    expect(parseMicroShader('x', 'float a;\r\n//# main\r\na = 1.0;').main).toBe('a = 1.0;');
  });

  it('keeps a chunk to its stage', () => {
    expect(parseMicroShader('x', '//# stage vertex\n').stage).toBe('vertex');
    expect(parseMicroShader('x', '').stage).toBeUndefined();
    expect(() => parseMicroShader('x', '//# stage pixel\n')).toThrow(/"x" has the stage "pixel"; stages are vertex/);
  });

  it('refuses includes in the main part and names that a frame line cannot hold', () => {
    expect(() => parseMicroShader('x', '//# main\n#include "y"')).toThrow(/"x" includes a chunk in its main part/);
    expect(() => parseMicroShader('x>', '')).toThrow(/name "x>"/);
  });
});

describe('formatMicroShader', () => {
  it('gives back the text of a file', () => {
    expect(formatMicroShader(parseMicroShader('x', TEXT))).toBe(TEXT);
  });

  it.each([
    { name: 'x', header: 'float a;', main: 'a = 1.0;', dependencies: ['b', 'c'], stage: 'vertex' },
    { name: 'x', header: '', main: 'a = 1.0;', dependencies: [] },
    { name: 'x', header: '#include "c"\nfloat a;\n', main: '', dependencies: ['b', 'c'] },
  ] as const)('writes a chunk that was not read from a file so that it reads the same: %j', (chunk) => {
    const read = parseMicroShader('x', formatMicroShader(chunk));
    expect(read.main).toBe(chunk.main);
    expect(read.stage).toBe('stage' in chunk ? chunk.stage : undefined);
    expect(read.dependencies.toSorted()).toEqual(chunk.dependencies.toSorted());
    expect(formatMicroShader(read)).toBe(formatMicroShader(chunk));
  });
});
