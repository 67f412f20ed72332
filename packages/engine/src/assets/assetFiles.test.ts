import { DataTexture, DataUtils, FloatType, HalfFloatType, LinearSRGBColorSpace, Mesh, RGBAFormat } from 'three';
import { describe, expect, test } from 'vitest';
import { ModelRenderer } from '../components/ModelRenderer';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { GameObject } from '../core/GameObject';
import { gameObjectOf } from '../core/gameObjectOf';
import { Scene } from '../core/Scene';
import { containerContent, inlineAssets, writeContainer } from '../files/container';
import { deserialize } from '../files/deserialize';
import { readSceneFile } from '../files/readSceneFile';
import { serialize } from '../files/serialize';
import { AssetLibrary } from './AssetLibrary';
import { importModel } from '../components/importModel';
import { packGltf } from '../files/packGltf';
import { readGltfJson } from '../guard/gltf/readGltfJson';

const bytesOf = (text: string): ArrayBuffer => new TextEncoder().encode(text).buffer as ArrayBuffer;
const latin = (text: string): ArrayBuffer => Uint8Array.from(text, (letter) => letter.charCodeAt(0)).buffer;

/** A red triangle on two nodes of one mesh, with an animation along x. */
const gltf = {
  asset: { version: '2.0' },
  scene: 0,
  scenes: [{ nodes: [0] }],
  nodes: [
    { name: 'Top', children: [1, 2] },
    { name: 'Left', mesh: 0 },
    { name: 'Right', mesh: 0, translation: [2, 0, 0] },
  ],
  meshes: [{ name: 'Tri', primitives: [{ attributes: { POSITION: 0 }, material: 0 }] }],
  materials: [{ name: 'Red', pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1] } }],
  animations: [
    {
      name: 'Slide',
      channels: [{ sampler: 0, target: { node: 1, path: 'translation' } }],
      samplers: [{ input: 1, output: 2 }],
    },
  ],
  accessors: [
    { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] },
    { bufferView: 1, componentType: 5126, count: 2, type: 'SCALAR', min: [0], max: [1] },
    { bufferView: 2, componentType: 5126, count: 2, type: 'VEC3' },
  ],
  bufferViews: [
    { buffer: 0, byteLength: 36 },
    { buffer: 1, byteLength: 8 },
    { buffer: 1, byteOffset: 8, byteLength: 24 },
  ],
  buffers: [
    { uri: 'shape%20data.bin', byteLength: 36 },
    { uri: 'motion.bin', byteLength: 32 },
  ],
};

const parts: Record<string, Float32Array<ArrayBuffer>> = {
  'shape%20data.bin': new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]),
  'motion.bin': new Float32Array([0, 1, 0, 0, 0, 4, 0, 0]),
};

const pack = (): Promise<ArrayBuffer> =>
  packGltf(bytesOf(JSON.stringify(gltf)), async (uri) => parts[uri]?.buffer ?? null);

async function library(): Promise<AssetLibrary> {
  const assets = new AssetLibrary();
  assets.registerFile('tri.glb', new Blob([await pack()]));
  return assets;
}

const hdr = latin('#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x80\x80\x80\x82\x80\x80\x80\x81');

describe('packGltf', () => {
  test('makes one file of many', async () => {
    const json = readGltfJson(await pack());
    expect(json.buffers).toEqual([{ byteLength: 68 }]);
    expect(json.bufferViews![2]).toEqual({ buffer: 0, byteOffset: 44, byteLength: 24 });
  });

  test('takes pictures in, and names what is missing', async () => {
    const json = bytesOf(JSON.stringify({ asset: { version: '2.0' }, images: [{ uri: 'a.png' }, { uri: 'b/c.jpg' }] }));
    const packed = readGltfJson(await packGltf(json, async (uri) => bytesOf(uri)));
    expect(packed.images).toEqual([
      { mimeType: 'image/png', bufferView: 0 },
      { mimeType: 'image/jpeg', bufferView: 1 },
    ]);
    await expect(packGltf(json, async () => null)).rejects.toThrow('it needs a.png, b/c.jpg: drop the whole folder');
  });
});

describe('a model', () => {
  test('is read once, and drawn by each ModelRenderer from the same geometry', async () => {
    const assets = await library();
    const scene = new Scene({ assets });
    const renderers = [1, 2].map(() => {
      const object = new GameObject('Model');
      scene.add(object);
      return object.addComponent(ModelRenderer, { model: 'tri.glb', castShadow: false });
    });
    expect(renderers[0].three).toBeNull();
    await assets.load('tri.glb');
    const meshes = renderers.map(({ three }) => three!.getObjectByName('Left') as Mesh);
    expect(meshes[0]).not.toBe(meshes[1]);
    expect(meshes[0].geometry).toBe(meshes[1].geometry);
    expect(meshes[0].material).toBe(meshes[1].material);
    expect(meshes[0].castShadow).toBe(false);
    expect(gameObjectOf(meshes[1])).toBe(renderers[1].gameObject);
    renderers.forEach(({ gameObject }) => gameObject.dispose());
    expect(assets.uses.size).toBe(0);
  });

  test('plays its animation in step with the time of the scene', async () => {
    const assets = await library();
    await assets.load('tri.glb');
    const scene = new Scene({ assets });
    const object = new GameObject('Model');
    scene.add(object);
    const renderer = object.addComponent(ModelRenderer, { model: 'tri.glb', animation: 'Slide' });
    expect(renderer.animations).toEqual(['Slide']);
    scene.setTime(0.5);
    expect(renderer.three!.getObjectByName('Left')!.position.x).toBeCloseTo(2, 5);
    expect(assets.model('tri.glb').scene.getObjectByName('Left')!.position.x).toBe(0);
    scene.reset();
    expect(renderer.three!.getObjectByName('Left')!.position.x).toBe(0);
  });

  test('brings its parts, each once, which leave and come back with it', async () => {
    const assets = await library();
    await assets.load('tri.glb');
    expect(assets.partsOf('tri.glb')).toEqual(['tri.glb/mesh-1', 'tri.glb/material-1-Red', 'tri.glb/clip-1-Slide']);
    expect(assets.clip('tri.glb/clip-1-Slide').name).toBe('Slide');
    expect(assets.modelOf('tri.glb/mesh-1')).toBe('tri.glb');
    const taken = assets.take('tri.glb');
    expect(assets.list('mesh')).not.toContain('tri.glb/mesh-1');
    assets.restore(taken);
    expect(assets.mesh('tri.glb/mesh-1').getAttribute('position').count).toBe(3);
    expect(assets.files.map(({ name }) => name)).toEqual(['tri.glb']);
    assets.unregister('tri.glb');
    expect(assets.has('tri.glb/mesh-1')).toBe(false);
  });

  test('becomes GameObjects that share its parts', async () => {
    const assets = await library();
    await assets.load('tri.glb');
    const root = importModel(assets.model('tri.glb'), assets, 'tri.glb');
    const [left, right] = ['Left', 'Right'].map((name) => root.find(name)!);
    expect(right.transform.position).toEqual([2, 0, 0]);
    expect(left.getComponent(ObjectRenderer)!.mesh).toBe('tri.glb/mesh-1');
    expect(right.getComponent(ObjectRenderer)!.material).toBe('tri.glb/material-1-Red');
  });
});

describe('a container', () => {
  async function filled(): Promise<Scene> {
    const assets = await library();
    assets.registerFile('sky.hdr', new Blob([hdr]));
    await Promise.all([assets.load('tri.glb'), assets.load('sky.hdr')]);
    const scene = new Scene({ name: 'Box', assets });
    scene.add(importModel(assets.model('tri.glb'), assets, 'tri.glb'));
    const object = new GameObject('Whole');
    object.addComponent(ModelRenderer, { model: 'tri.glb' });
    scene.add(object);
    scene.settings.environment = 'sky.hdr';
    return scene;
  }

  test('holds the scene and its assets, and is the same for the same scene', async () => {
    const scene = await filled();
    const bytes = await writeContainer(containerContent(scene));
    expect(await writeContainer(containerContent(scene))).toEqual(bytes);
    const { text, fileOf } = await readSceneFile(bytes);
    const copy = await deserialize(text, { fileOf });
    expect(serialize(copy)).toEqual(serialize(scene));
    expect((await copy.assets.fileOf('tri.glb')!.arrayBuffer()).byteLength).toBe((await pack()).byteLength);
    const environment = copy.three.environment!;
    expect(environment.type).toBe(HalfFloatType);
    expect(environment.image).toMatchObject({ width: 2, height: 1 });
  });

  test('may be plain JSON with the bytes inside', async () => {
    const scene = await filled();
    const file = await inlineAssets(containerContent(scene));
    const copy = await deserialize(JSON.stringify(file));
    expect(copy.find('Left')!.getComponent(ObjectRenderer)!.three).not.toBeNull();
    expect(serialize(copy).objects).toEqual(file.objects);
    // assets inside the file stay inside
    expect((await inlineAssets(containerContent(copy))).assets).toEqual(file.assets);
  });

  test('of version 1 is still read', async () => {
    const scene = await deserialize({ format: 'farol-scene', version: 1, name: 'Old', objects: [] });
    expect(serialize(scene)).toMatchObject({ name: 'Old', version: 3 });
  });

  test('that is broken says what is wrong with it', async () => {
    const bytes = await writeContainer(containerContent(await filled()));
    await expect(readSceneFile(bytes.subarray(0, bytes.length - 40))).rejects.toThrow(/cut short or damaged/);
    await expect(readSceneFile(new Uint8Array())).rejects.toThrow(/is empty/);
    await expect(readSceneFile(new Uint8Array(bytesOf('glTF…')))).rejects.toThrow(/is a GLB, not a scene of Farol/);
    const { text, fileOf } = await readSceneFile(bytes);
    const assets = new AssetLibrary();
    await expect(deserialize(text, { assets })).rejects.toThrow(
      /assets\[1\].file names 'assets\/tri\.glb', which did not come with the scene: open the \.farol file/,
    );
    const cut = { fileOf: (path: string) => fileOf(path)!.slice(0, 30) };
    await expect(deserialize(text, { assets, ...cut })).rejects.toThrow(
      /'tri\.glb' could not be loaded: it is cut short/,
    );
    expect(assets.files).toEqual([]);
    const renamed = text.replaceAll('tri.glb/mesh-1', 'tri.glb/mesh-9');
    await expect(deserialize(renamed, { assets, fileOf })).rejects.toThrow(/mesh names the mesh 'tri\.glb\/mesh-9'/);
    expect(assets.list('mesh')).not.toContain('tri.glb/mesh-1');
  });
});

describe('a broken asset', () => {
  test.each([
    [
      'cut.glb',
      async () => (await pack()).slice(0, 300),
      /'cut\.glb' could not be loaded: it is cut short \(its header/,
    ],
    ['text.glb', async () => bytesOf('hello'), /its JSON cannot be read/],
    ['empty.hdr', async () => new ArrayBuffer(0), /the file is empty: choose it again/],
    ['cut.hdr', async () => hdr.slice(0, 20), /its HDR data are damaged or cut short/],
    ['cut.exr', async () => latin('v/1\x01\x02\0\0\0chan'), /its EXR data are damaged or cut short/],
    ['picture.exr', async () => latin('\x89PNG\r\n'), /its bytes are PNG, not OpenEXR: was another file renamed\?/],
    ['cut.png', async () => latin('\x89PNG\r\n'), /it begins as PNG, and is damaged or cut short/],
    ['text.jpg', async () => bytesOf('hello'), /not PNG, JPEG or WebP: was another file renamed\?/],
  ])('%s is named with what is wrong', async (name, make, message) => {
    const assets = new AssetLibrary();
    assets.registerFile(name, new Blob([await make()]));
    await expect(assets.load(name)).rejects.toThrow(message);
  });

  test('of a kind that cannot be read is refused by its name', () => {
    expect(() => new AssetLibrary().registerFile('film.mp4', new Blob())).toThrow(
      /'film\.mp4' cannot be read: only \.glb/,
    );
  });
});

test('an EXR becomes a texture of linear light, the right way up', async () => {
  const { EXRExporter } = await import('three/addons/exporters/EXRExporter.js');
  const pixels = new Float32Array([4, 2, 1, 1, 0.5, 0.25, 0.125, 1]);
  const source = new DataTexture(pixels, 2, 1, RGBAFormat, FloatType);
  const bytes = await new EXRExporter().parse(source);
  const assets = new AssetLibrary();
  assets.registerFile('sky.exr', new Blob([bytes as Uint8Array<ArrayBuffer>]));
  await assets.load('sky.exr');
  const { image, type, colorSpace } = assets.texture('sky.exr');
  expect(image).toMatchObject({ width: 2, height: 1 });
  expect([type, colorSpace]).toEqual([HalfFloatType, LinearSRGBColorSpace]);
  const { data } = image as { data: Uint16Array };
  expect([0, 1, 2, 4].map((i) => DataUtils.fromHalfFloat(data[i]))).toEqual([4, 2, 1, 0.5]);
});

test('an EXR or HDR of absurd size is refused before memory is taken', async () => {
  const int = (...values: number[]): string =>
    String.fromCharCode(...new Uint8Array(new Int32Array(values).buffer)) as string;
  const attribute = (name: string, type: string, value: string): string =>
    `${name}\0${type}\0${int(value.length)}${value}`;
  const exr = (window: number[], tiles: string): ArrayBuffer =>
    latin(`v/1\x01\x02\0\0\0${attribute('dataWindow', 'box2i', int(...window))}${tiles}\0${'\0'.repeat(64)}`);
  const absurd: [string, ArrayBuffer][] = [
    ['a.exr', exr([0, 0, 59_999, 59_999], '')],
    ['b.exr', exr([-2_000_000_000, 0, 2_000_000_000, 0], '')],
    ['c.exr', exr([0, 0, 1, 1], attribute('tiles', 'tiledesc', `${int(60_000, 60_000)}\0`))],
    ['d.hdr', latin(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y\t60000\t+X\t60000\n${'\x02\x02'.repeat(99)}`)],
  ];
  for (const [name, bytes] of absurd) {
    const assets = new AssetLibrary();
    assets.registerFile(name, new Blob([bytes]));
    await expect(assets.load(name)).rejects.toThrow(/its picture has \d+ × \d+ pixels/);
  }
});

test('an asset whose name has no ending is what the file says, as bytes in it and as a file beside it', async () => {
  const ply = [
    'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z',
    'element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n',
  ].join('\n');
  const file = serialize(new Scene());
  file.assets = [{ name: 'own', type: 'mesh', url: `data:application/octet-stream;base64,${btoa(ply)}` }];
  const values = { mesh: 'own' };
  file.objects = [
    { id: 'o', name: 'Own', parent: null, components: [{ type: 'ObjectRenderer', version: 1, id: 'r', values }] },
  ];
  const scene = await deserialize(file);
  expect(scene.assets.mesh('own').getAttribute('position').count).toBe(3);
  const packed = await readSceneFile(await writeContainer(containerContent(scene)));
  const again = await deserialize(packed.text, { fileOf: packed.fileOf });
  expect(again.assets.typeOf('own')).toBe('mesh');
  expect(serialize(again)).toEqual(serialize(scene));
  // a contradicting file extension is still an error
  file.assets = [{ ...file.assets[0], name: 'own.png' }];
  values.mesh = 'own.png';
  await expect(deserialize(file)).rejects.toThrow('says mesh, but its name is that of a texture');
});
