import { describe, expect, test, vi } from 'vitest';
import { AssetLibrary } from '../assets/AssetLibrary';
import { AddressRefusedError, foreignOrigin } from '../assets/foreignOrigin';
import { deserialize, type MayFetch } from './deserialize';
import type { FarolFile } from './FarolFile';
import { type ForeignAddress, foreignAddresses } from './foreignAddresses';
import { parseFile } from './parseFile';
import { serialize } from './serialize';

const page = 'https://farol.example/editor/index.html';

test.each([
  ['models/robot.glb', null],
  ['/robot.glb', null],
  ['https://farol.example/robot.glb', null],
  ['data:,abc', null],
  ['blob:https://farol.example/1', null],
  ['http://farol.example/robot.glb', 'http://farol.example'],
  ['https://farol.example:8443/a', 'https://farol.example:8443'],
  ['//evil.example/a', 'https://evil.example'],
  ['\\\\evil.example\\a', 'https://evil.example'],
  [' \thttps://e\nvil.example/a', 'https://evil.example'],
  ['http://192.168.0.1/admin', 'http://192.168.0.1'],
  ['http://[::1]/', 'http://[::1]'],
  ['https://farol.example@evil.example/', 'https://evil.example'],
  ['ftp://evil.example/a', 'ftp://evil.example'],
  ['file://server/share', 'file://server'],
  ['javascript:alert(1)', 'javascript://'],
])('%j leads to %j', (url, origin) => {
  expect(foreignOrigin(url, page)).toBe(origin);
});

test('a page from a disk, and none at all', () => {
  expect(foreignOrigin('a.glb', 'file:///home/me/page.html')).toBeNull();
  expect(foreignOrigin('file://server/a.glb', 'file:///home/me/page.html')).toBe('file://server');
  expect(foreignOrigin('a.glb')).toBeNull();
  expect(foreignOrigin('https://evil.example/a')).toBe('https://evil.example');
  expect(foreignOrigin('http://', page)).toBeNull();
});

const file = (): FarolFile => ({
  format: 'farol-scene',
  version: 3,
  name: 'From elsewhere',
  settings: { environment: 'sky.hdr' },
  activeCamera: null,
  assets: [
    { name: 'own', type: 'mesh', url: 'own.ply' },
    { name: 'sky.hdr', type: 'texture', url: 'https://sky.example/sky.hdr' },
    { name: 'robot.glb', type: 'model', url: 'https://robots.example/robot.glb' },
  ],
  objects: [
    {
      id: 'a',
      name: 'A',
      parent: null,
      components: [
        {
          type: 'ObjectRenderer',
          version: 1,
          id: 'a:r',
          values: { mesh: 'robot.glb/mesh-1', material: 'robot.glb/material-1', map: 'robot.glb/texture-1' },
        },
        { type: 'ModelRenderer', version: 1, id: 'a:m', values: { model: 'robot.glb' } },
      ],
    },
    {
      id: 'b',
      name: 'B',
      parent: null,
      components: [
        { type: 'ObjectRenderer', version: 1, id: 'b:r', values: { mesh: 'own', material: 'robot.glb/material-1' } },
      ],
    },
  ],
});

const ply = `ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
`;

/** A library that records requested addresses, and can only load the page's own mesh. */
function library(): { assets: AssetLibrary; asked: [string, boolean | undefined][] } {
  const asked: [string, boolean | undefined][] = [];
  const assets = new AssetLibrary({
    urls: { logo: 'https://host.example/logo.ply' },
    fetchBytes: async (url, options) => {
      asked.push([url, options?.isLimited]);
      return new TextEncoder().encode(ply).buffer as ArrayBuffer;
    },
  });
  return { assets, asked };
}

describe('foreign addresses of a scene', () => {
  test('are listed before anything is loaded', () => {
    expect(foreignAddresses(parseFile(file()), page)).toEqual([
      { asset: 'sky.hdr', url: 'https://sky.example/sky.hdr', origin: 'https://sky.example' },
      { asset: 'robot.glb', url: 'https://robots.example/robot.glb', origin: 'https://robots.example' },
    ]);
  });

  test('are asked about once; what is refused is not asked for, is named, and the rest opens and saves as it was', async () => {
    const { assets, asked } = library();
    const questions: (readonly ForeignAddress[])[] = [];
    const failed: [string, Error | undefined][] = [];
    assets.onChange(({ kind, name, error }) => kind === 'failed' && failed.push([name, error]));
    const mayFetch = (addresses: readonly ForeignAddress[]): MayFetch => {
      questions.push(addresses);
      return false;
    };
    const scene = await deserialize(file(), { assets, mayFetch });
    expect(questions.map((each) => each.map(({ origin }) => origin))).toEqual([
      ['https://sky.example', 'https://robots.example'],
    ]);
    expect(asked).toEqual([['own.ply', false]]);
    expect(failed.filter(([name]) => !name.includes('/')).map(([name]) => name)).toEqual(['sky.hdr', 'robot.glb']);
    for (const [, error] of failed) expect(error).toBeInstanceOf(AddressRefusedError);
    expect(failed[0][1]?.message).toBe(
      "The asset 'sky.hdr' was not fetched: https://sky.example is not allowed. Open the scene again and allow it.",
    );
    scene.three.updateMatrixWorld();
    expect(scene.find('b')!.object3D.children).toHaveLength(1);
    expect(serialize(scene)).toMatchObject({ ...file(), objects: [{ id: 'a' }, { id: 'b' }] });
    const saved = scene
      .find('a')!
      .components.slice(1)
      .map((each) => each.authoredValues());
    expect(saved).toMatchObject(file().objects[0].components.map(({ values }) => values));
    // addresses of the host need no permission
    await assets.load('logo');
    expect(asked.at(-1)).toEqual(['https://host.example/logo.ply', false]);
    scene.dispose();
  });

  test('are fetched from the origins that were allowed, without cookies and without going on', async () => {
    const { assets, asked } = library();
    const input = file();
    input.assets = [
      { name: 'one', type: 'mesh', url: 'https://one.example/a.ply' },
      { name: 'two', type: 'mesh', url: 'https://two.example/a.ply' },
    ];
    input.settings = {};
    input.objects = input.objects.slice(1).flatMap((object) =>
      ['one', 'two'].map((mesh) => ({
        ...object,
        id: mesh,
        components: [{ type: 'ObjectRenderer', version: 1, id: `${mesh}:r`, values: { mesh } }],
      })),
    );
    const scene = await deserialize(input, { assets, mayFetch: async () => ['https://two.example'] });
    expect(asked).toEqual([['https://two.example/a.ply', true]]);
    expect(scene.find('two')!.object3D.children).toHaveLength(1);
    expect(scene.find('one')!.object3D.children).toHaveLength(0);
    await expect(deserialize('{}', { assets, mayFetch: () => true })).rejects.toThrow(/format/);
    expect([...assets.allowedOrigins!]).toEqual(['https://two.example']);
    scene.dispose();
  });

  test('of a scene that names none are not asked about, and later ones are refused', async () => {
    const { assets, asked } = library();
    const scene = await deserialize(
      { ...file(), assets: [], settings: {}, objects: [] },
      { assets, mayFetch: () => expect.unreachable() },
    );
    assets.registerUrl('later', 'https://later.example/a.ply');
    await expect(assets.load('later')).rejects.toThrow(AddressRefusedError);
    expect(asked).toEqual([]);
    scene.dispose();
  });

  test('without the question all are fetched, as before', async () => {
    const { assets, asked } = library();
    await expect(deserialize(file(), { assets })).rejects.toThrow(/sky\.hdr/);
    expect(asked.map(([url]) => url)).toContain('https://robots.example/robot.glb');
  });
});

test('an address beside the page that a scene names is not followed to another place, one of the host is', async () => {
  const asked: [string, RequestRedirect | undefined][] = [];
  vi.stubGlobal('fetch', async (url: string, { redirect }: RequestInit) => {
    asked.push([url, redirect]);
    throw new TypeError('fetch failed');
  });
  const assets = new AssetLibrary({ urls: { logo: 'logo.ply' } });
  assets.allowedOrigins = new Set(['https://two.example']);
  for (const url of ['go.ply?to=https://evil.example', 'https://two.example/a.ply']) assets.registerUrl(url, url);
  const said: string[] = [];
  for (const name of ['logo', 'go.ply?to=https://evil.example', 'https://two.example/a.ply'])
    await assets.load(name).catch((error: Error) => said.push(error.message));
  vi.unstubAllGlobals();
  expect(asked.map(([, redirect]) => redirect)).toEqual([undefined, 'error', 'error']);
  expect(said[1]).toMatch(/cannot be reached, or sends on to another address: check the address\.$/);
});

test('a model of which parts alone are used stays in the file', async () => {
  const { assets } = library();
  const input = file();
  input.objects[0].components.pop();
  const scene = await deserialize(input, { assets, mayFetch: () => false });
  expect(serialize(scene).assets.map(({ name }) => name)).toContain('robot.glb');
  scene.dispose();
});

test('an asset that cannot be registered leaves none behind', async () => {
  const { assets } = library();
  const input = file();
  input.objects = [];
  input.settings = {};
  input.assets = [
    { name: 'first', type: 'mesh', url: 'first.ply' },
    { name: 'no ending', type: 'texture', url: 'data:,abc' },
    { name: 'wrong.png', type: 'mesh', url: 'data:,abc' },
  ];
  await expect(deserialize(input, { assets })).rejects.toThrow(
    /:\nassets\[2\]\.type says mesh, but its name is that of a texture/,
  );
  expect(assets.has('no ending')).toBe(false);
  expect(assets.has('first')).toBe(false);
});
