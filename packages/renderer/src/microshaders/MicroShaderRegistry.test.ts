import { afterEach, describe, expect, it, vi } from 'vitest';
import { type MicroShaderListener, MicroShaderRegistry } from './MicroShaderRegistry';
import type { ShaderSource } from './Shader';

const chunk = (name: string) => ({ name, header: '', main: '', dependencies: [] });

/** A compiler that refuses sources with the word BROKEN, and records living programs. */
function fakeCompiler() {
  const alive = new Set<ShaderSource>();
  return {
    alive,
    compile(source: ShaderSource) {
      if (/BROKEN/.test(source.vertexShader + source.fragmentShader)) throw new Error(`refused ${source.name}`);
      alive.add(source);
      return source;
    },
    release: (program: ShaderSource) => void alive.delete(program),
  };
}

function registryOf(chunks: Record<string, string>) {
  const compiler = fakeCompiler();
  const registry = new MicroShaderRegistry<ShaderSource>(null, { compiler });
  for (const [name, text] of Object.entries(chunks)) registry.loadGLSL(name, text);
  return { registry, compiler };
}

const LAYERED = {
  a: 'float a;',
  b: '#include "a"\nfloat b;\n//# main\nb = a;',
  c: '#include "a"\n#include "b"\nfloat c;\n//# main\nc = b;',
  d: 'float d;\n//# main\nd = 1.0;',
};

describe('composing', () => {
  it('puts each header once, after those it depends on, between frame lines', () => {
    const { registry } = registryOf(LAYERED);
    expect(registry.header(['c', 'a', 'b'])).toBe(
      '// <a>\nfloat a;\n// </a>\n// <b>\n\nfloat b;\n// </b>\n// <c>\n\n\nfloat c;\n// </c>\n',
    );
  });

  it('puts the main parts of the listed chunks only, in the order of the list', () => {
    const { registry } = registryOf(LAYERED);
    const { vertexShader, fragmentShader } = registry.compose(['d'], ['d', 'c']);
    expect(vertexShader).toBe('// <d>\nfloat d;\n// </d>\nvoid main() {\n// <d> 3\nd = 1.0;\n// </d>\n}\n');
    expect(fragmentShader.slice(fragmentShader.indexOf('void'))).toBe(
      'void main() {\n// <d> 3\nd = 1.0;\n// </d>\n// <c> 5\nc = b;\n// </c>\n}\n',
    );
  });

  it("leaves three's includes as they are", () => {
    const { registry } = registryOf({ a: '#include <common>\nfloat a;' });
    expect(registry.header(['a'])).toMatch(/^#include <common>$/m);
  });

  it('orders any web of dependencies so that each comes after its own', () => {
    let state = 7;
    const random = (n: number) => (state = (state * 48271) % 2147483647) % n;
    for (let round = 0; round < 50; round++) {
      const registry = new MicroShaderRegistry();
      for (let i = 0; i < 20; i++) {
        const dependencies = i === 0 ? [] : Array.from({ length: random(4) }, () => `c${random(i)}`);
        registry.add({ name: `c${i}`, header: `float c${i};`, main: '', dependencies });
      }
      const order = [...registry.header(['c19', 'c3', 'c11']).matchAll(/^float (c\d+);$/gm)].map((match) => match[1]);
      expect(new Set(order).size).toBe(order.length);
      for (const name of order) {
        for (const dependency of registry.get(name)!.dependencies) {
          expect(order.indexOf(dependency)).toBeLessThan(order.indexOf(name));
          expect(order).toContain(dependency);
        }
      }
    }
  });

  it('names the path of a cycle and of an unknown chunk, and the name that was meant', () => {
    const { registry } = registryOf({
      a: '#include "b"',
      b: '#include "c"',
      c: '#include "b"',
      d: '#include "lightTabel"',
      lightTable: '',
    });
    expect(() => registry.header(['a'])).toThrow('Microshader cycle: b -> c -> b');
    expect(() => registry.header(['d'])).toThrow(
      'Unknown microshader "lightTabel" (d -> lightTabel); did you mean "lightTable"?',
    );
    expect(() => registry.header(['somethingElse'])).toThrow(/Unknown microshader "somethingElse"; add it/);
  });

  it('refuses a chunk of the other stage, also as a dependency', () => {
    const { registry } = registryOf({ v: '//# stage vertex', f: '//# stage fragment', uses: '#include "v"' });
    expect(() => registry.compose(['v'], ['f'])).not.toThrow();
    expect(() => registry.compose([], ['uses'])).toThrow(
      'Microshader "v" is for the vertex stage, and a fragment shader uses it; give it the stage both.',
    );
    expect(() => registry.compose(['f'], [])).toThrow(/"f" is for the fragment stage/);
  });
});

describe('adding', () => {
  it('refuses a known name, the parent’s too, and then adds nothing of the list', async () => {
    const parent = registryOf({ a: 'float a;' }).registry;
    const registry = new MicroShaderRegistry(parent);
    expect(() => registry.add([chunk('b'), chunk('a')])).toThrow(/"a" exists already; use replace\(\)/);
    expect(() => registry.add([chunk('b'), chunk('b')])).toThrow(/"b" exists already/);
    await expect(
      registry.loadXML('<microshaders><microshader name="b"/><microshader name="a"/></microshaders>', 'f.xml'),
    ).rejects.toThrow(/f\.xml: microshader "a"/);
    expect(registry.names()).toEqual(['a']);
  });

  it('never changes its parent', () => {
    const parent = registryOf({ a: 'float a;' }).registry;
    const registry = new MicroShaderRegistry(parent);
    registry.replace('a', 'float other;');
    registry.loadGLSL('b', '');
    expect(registry.header(['a'])).toContain('float other;');
    expect(parent.header(['a'])).toContain('float a;');
    expect(parent.names()).toEqual(['a']);
  });
});

describe('getShader', () => {
  it('compiles once a name', () => {
    const { registry, compiler } = registryOf(LAYERED);
    const shader = registry.getShader('s', ['d'], ['c']);
    expect(registry.getShader('s', ['d'], ['c'])).toBe(shader);
    expect([...compiler.alive]).toEqual([shader.program]);
    expect(shader.fragmentShader).toBe(registry.compose(['d'], ['c']).fragmentShader);
  });

  it('refuses a known name with other chunks, with both lists', () => {
    const { registry } = registryOf(LAYERED);
    registry.getShader('s', ['d'], ['b', 'c']);
    expect(() => registry.getShader('s', ['d'], ['c', 'b'])).toThrow(
      'Shader "s" is made of vertex [d], fragment [b, c], and is requested as vertex [d], fragment [c, b]; give it another name.',
    );
  });

  it('keeps nothing of a shader that does not compile', () => {
    const { registry } = registryOf({ ...LAYERED, broken: 'BROKEN' });
    expect(() => registry.getShader('s', ['d'], ['broken'])).toThrow('refused s');
    expect(registry.getShader('s', ['d'], ['c']).program).not.toBeNull();
  });

  it('composes without a compiler', () => {
    const registry = new MicroShaderRegistry();
    registry.loadGLSL('a', 'float a;');
    expect(registry.getShader('s', ['a'], ['a'])).toMatchObject({ program: null, revision: 0 });
  });
});

describe('loading a file', () => {
  afterEach(() => vi.unstubAllGlobals());
  const xml = '<microshaders><microshader name="a" dependencies="b"/><microshader name="b"/></microshaders>';

  it('gives a promise only when a chunk or a dependency is unknown, and loads once', async () => {
    const fetched = vi.fn<typeof fetch>(async () => new Response(xml));
    vi.stubGlobal('fetch', fetched);
    const { registry } = registryOf({ d: '', needsB: '#include "b"' });
    expect(registry.getShader('known', ['d'], ['d'], 'f.xml')).not.toBeInstanceOf(Promise);
    expect(fetched).not.toHaveBeenCalled();
    const both = [registry.getShader('s', ['d'], ['needsB'], 'f.xml'), registry.getShader('t', ['a'], ['a'], 'f.xml')];
    expect(both[0]).toBeInstanceOf(Promise);
    expect((await Promise.all(both)).map(({ name }) => name)).toEqual(['s', 't']);
    expect(fetched.mock.calls).toEqual([['f.xml']]);
    expect(registry.names()).toEqual(['d', 'needsB', 'a', 'b']);
  });

  it('names the file that cannot be loaded, and tries again when asked again', async () => {
    const { registry } = registryOf({});
    vi.stubGlobal('fetch', async () => new Response('', { status: 404 }));
    await expect(registry.getShader('s', ['a'], ['a'], 'f.xml')).rejects.toThrow(/f\.xml: the server answers 404/);
    vi.stubGlobal('fetch', async () => new Response('<html>'));
    await expect(registry.loadXMLFile('f.xml')).rejects.toThrow(/f\.xml:1: <html>/);
    vi.stubGlobal('fetch', async () => new Response(xml));
    expect(await registry.loadXMLFile('f.xml')).toEqual(['a', 'b']);
  });

  it('names a chunk that the file does not have either', async () => {
    vi.stubGlobal('fetch', async () => new Response(xml));
    await expect(registryOf({}).registry.getShader('s', ['aa'], ['a'], 'f.xml')).rejects.toThrow(
      /"aa"; did you mean "a"\?/,
    );
  });
});

function running() {
  const { registry, compiler } = registryOf(LAYERED);
  const usesA = registry.getShader('usesA', ['d'], ['c']);
  const other = registry.getShader('other', ['d'], ['d']);
  const changes: (readonly string[])[] = [];
  registry.onChange((names) => changes.push(names));
  return { registry, compiler, usesA, other, changes };
}

describe('replacing', () => {
  it('compiles the shaders that use the chunk, through dependencies too, and no other', () => {
    const { registry, compiler, usesA, other, changes } = running();
    const programs = [usesA.program, other.program];
    registry.replace('a', 'float a2;');
    expect(usesA.fragmentShader).toContain('float a2;');
    expect(usesA.program).not.toBe(programs[0]);
    expect([usesA.revision, other.revision]).toEqual([1, 0]);
    expect(other.program).toBe(programs[1]);
    expect(compiler.alive).toEqual(new Set([usesA.program, other.program]));
    expect(changes).toEqual([['a', 'b', 'c']]);
  });

  it('keeps everything as it was when a shader does not compile, and follows the next good edit', () => {
    const { registry, compiler, usesA, other, changes } = running();
    const programs = [usesA.program, other.program];
    const before = registry.header(['c']);
    registry.getShader('alsoD', ['d'], ['b', 'd']);
    const alive = new Set(compiler.alive);
    expect(() => registry.replace('d', 'BROKEN')).toThrow('refused usesA');
    expect(() => registry.replace('a', 'BROKEN')).toThrow('refused usesA');
    expect(registry.header(['c'])).toBe(before);
    expect([usesA.program, other.program]).toEqual(programs);
    expect(compiler.alive).toEqual(alive);
    expect(changes).toEqual([]);
    expect(registry.revision(['c', 'd'])).toBe(0);
    registry.replace('a', 'float fine;');
    expect(usesA.fragmentShader).toContain('float fine;');
  });

  it('lets a check that throws prevent it, after it saw the new text', () => {
    const { registry, compiler, usesA } = running();
    const program = usesA.program;
    const seen: string[] = [];
    const end = registry.addCheck((names) => {
      seen.push(`${names.join()}: ${registry.header(['b'])}`);
      throw new Error('checked');
    });
    expect(() => registry.replace('b', 'float b2;')).toThrow('checked');
    expect(seen).toEqual(['b,c: // <b>\nfloat b2;\n// </b>\n']);
    expect(usesA.program).toBe(program);
    expect(compiler.alive.size).toBe(2);
    end();
    registry.replace('b', 'float b2;');
    expect(usesA.fragmentShader).toContain('float b2;');
  });

  it('refuses unknown names, other names, cycles and unknown dependencies, and changes nothing', () => {
    const { registry, changes } = running();
    const before = registry.header(['c', 'd']);
    expect(() => registry.replace('e', '')).toThrow(/Unknown microshader "e"/);
    expect(() => registry.replace('a', { name: 'b', header: '', main: '', dependencies: [] })).toThrow(
      /by one named "b"/,
    );
    expect(() => registry.replace('a', '#include "c"')).toThrow('Microshader cycle: a -> c -> a');
    expect(() => registry.replace('a', '#include "e"')).toThrow(/Unknown microshader "e" \(a -> e\)/);
    expect(registry.header(['c', 'd'])).toBe(before);
    expect(changes).toEqual([]);
  });

  it('has a key that tells registries of other texts apart, and those of equal texts not', () => {
    const names = ['c'];
    const edited = (text: string) => {
      const made = new MicroShaderRegistry();
      made.add({ name: 'a', header: 'float a;', main: '', dependencies: [] });
      made.add({ name: 'c', header: 'float c;', main: '', dependencies: ['a'] });
      if (text) made.replace('a', { name: 'a', header: text, main: '', dependencies: [] });
      return made;
    };
    expect(edited('').textKey(names)).toBe('');
    const first = edited('float first;');
    expect(first.textKey(names)).not.toBe(edited('float second;').textKey(names));
    expect(first.textKey(names)).toBe(edited('float first;').textKey(names));
    const before = first.textKey(names);
    first.replace('a', { name: 'a', header: 'float second;', main: '', dependencies: [] });
    expect(first.textKey(names)).not.toBe(before);
  });

  it('grows the revision of what uses the chunk, and of nothing else', () => {
    const { registry } = running();
    expect(registry.revision(['c', 'd'])).toBe(0);
    registry.replace('b', '#include "d"\nfloat b;');
    const first = registry.revision(['c']);
    expect(first).toBeGreaterThan(0);
    expect(registry.revision(['a', 'd'])).toBe(0);
    registry.replace('d', 'float d2;');
    expect(registry.revision(['c'])).toBeGreaterThan(first);
    expect(registry.revision(['a'])).toBe(0);
  });

  it('stops calling a listener that ended', () => {
    const { registry } = running();
    const listener = vi.fn<MicroShaderListener>();
    registry.onChange(listener)();
    registry.replace('a', 'float x;');
    expect(listener).not.toHaveBeenCalled();
  });

  it('frees each program once at the end', () => {
    const { registry, compiler } = running();
    registry.replace('a', 'float x;');
    registry.recompile();
    expect(compiler.alive.size).toBe(2);
    registry.dispose();
    expect(compiler.alive.size).toBe(0);
  });
});

describe('removing', () => {
  const layered = () => {
    const parent = new MicroShaderRegistry();
    parent.loadGLSL('a', 'float a;');
    parent.loadGLSL('b', '#include "a"\nfloat b;');
    const compiler = fakeCompiler();
    const registry = new MicroShaderRegistry<ShaderSource>(parent, { compiler });
    return { registry, shader: registry.getShader('s', ['a'], ['b']) };
  };

  it("puts the parent's chunk back", () => {
    const { registry, shader } = layered();
    const before = shader.fragmentShader;
    registry.replace('a', 'float other;');
    expect(registry.original('a')!.header).toBe('float a;');
    const revision = registry.revision(['b']);
    registry.remove('a');
    expect(shader.fragmentShader).toBe(before);
    expect(registry.revision(['b'])).toBeGreaterThan(revision);
    expect(() => registry.remove('a')).toThrow(/was not replaced/);
  });

  it('swaps what was added or is as the parent has it, what is edited once that is taken back', () => {
    const { registry } = layered();
    registry.loadGLSL('late', 'float late;');
    registry.loadGLSL('on', 'float on;');
    const changes: (readonly string[])[] = [];
    registry.onChange((names) => changes.push(names));
    registry.swap('late', 'on');
    registry.swap('a', 'on');
    expect(registry.get('late')).toMatchObject({ name: 'late', header: 'float on;' });
    expect(registry.get('a')).toMatchObject({ name: 'a', header: 'float on;' });
    expect(changes).toEqual([['late'], ['a', 'b']]);
    expect(() => registry.remove('late')).toThrow(/was not replaced/);
    registry.replace('late', 'float edited;');
    registry.swap('late', { ...chunk('late'), header: 'float more;' });
    expect(registry.get('late')!.header).toBe('float edited;');
    registry.remove('late');
    expect(registry.get('late')!.header).toBe('float more;');
    // a chunk replaced by its original text is not edited
    const before = registry.get('a')!;
    registry.replace('a', 'float edited;');
    registry.replace('a', before);
    registry.swap('a', 'late');
    expect(registry.get('a')!.header).toBe('float more;');
  });

  it('takes out a chunk of its own that nothing needs, and keeps one that is needed', () => {
    const { registry, shader } = layered();
    registry.loadGLSL('own', 'float own;');
    registry.replace('b', '#include "own"\nfloat b;');
    const program = shader.program;
    expect(() => registry.remove('own')).toThrow('"own" is included by "b"');
    expect(registry.has('own')).toBe(true);
    registry.remove('b');
    registry.remove('own');
    expect(registry.names()).toEqual(['a', 'b']);
    registry.loadGLSL('own', 'float own;');
    registry.getShader('t', ['own'], ['own']);
    expect(() => registry.remove('own')).toThrow(/Unknown microshader "own"/);
    expect(registry.has('own')).toBe(true);
    expect(shader.program).not.toBe(program);
  });
});
