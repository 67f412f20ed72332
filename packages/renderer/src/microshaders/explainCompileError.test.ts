import { describe, expect, it } from 'vitest';
import { explainCompileError } from './explainCompileError';
import { MicroShaderCompileError } from './MicroShaderCompileError';
import { MicroShaderRegistry } from './MicroShaderRegistry';

const registry = new MicroShaderRegistry();
registry.loadGLSL('colour', '// A colour.\n// Farol\nvec3 colour() { return vec3(1.0); }\n');
registry.loadGLSL(
  'light',
  '// A light.\n// Farol\n#include "colour"\n#include <common>\nfloat wrong = 1;\n//# main\nfloat a = 1.0;\nfloat b = c;\n',
);
await registry.loadXML(
  '<microshaders>\n<microshader name="out">\n<main>\n  gl_FragColor = d;\n</main></microshader></microshaders>',
);

// source for the driver: three adds lines before it, and expands its own include
const source = `#version 300 es\n#define THREE\n${registry.compose([], ['light', 'out']).fragmentShader.replace('#include <common>', 'float three1;\nfloat three2;')}// end`;
const lineOf = (text: string) => source.split('\n').findIndex((line) => line.includes(text)) + 1;

describe('explainCompileError', () => {
  it.each([
    ['colour()', 'colour', 3],
    ['three2', 'three/common', 2],
    ['float wrong', 'light', 5],
    ['float a', 'light', 7],
    ['float b', 'light', 8],
    ['gl_FragColor', 'out', 4],
    ['void main', null, lineOf('void main')],
    ['#define THREE', null, 2],
    ['// end', null, lineOf('// end')],
  ])('finds the line with %j in %s, line %i', (text, chunk, line) => {
    const [entry] = explainCompileError(`ERROR: 0:${lineOf(text)}: 'x' : undeclared identifier\n\0`, source);
    expect(entry).toMatchObject({ chunk, line, message: "'x' : undeclared identifier" });
    expect(entry.text).toContain(text);
  });

  it.each([
    ['ERROR: 0:LINE: bad', 'bad'],
    ['WARNING: 0:LINE: bad : worse', 'bad : worse'],
    ['0:LINE(12): error: bad', 'error: bad'],
    ['0(LINE) : error C1008: bad', 'error C1008: bad'],
  ])('reads the log of a driver that writes %j', (log, message) => {
    const entries = explainCompileError(`${log.replace('LINE', String(lineOf('float b')))}\n`, source);
    expect(entries).toEqual([{ chunk: 'light', line: 8, message, text: 'float b = c;' }]);
  });

  it('keeps lines without a number', () => {
    expect(explainCompileError('Too many samplers\n', source)).toEqual([
      { chunk: null, line: 0, message: 'Too many samplers', text: '' },
    ]);
  });

  it('makes a message that quotes the line', () => {
    const error = new MicroShaderCompileError('sky', 'fragment', `ERROR: 0:${lineOf('float b')}: bad`, source);
    expect(error.message).toBe(
      'Shader "sky" (fragment) does not compile:\n  microshader "light", line 8: bad\n    float b = c;',
    );
  });
});
