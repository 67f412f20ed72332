import { BufferGeometry, Float32BufferAttribute, Group, Mesh } from 'three';
import { describe, expect, test } from 'vitest';
import { AssetLibrary } from '../../assets/AssetLibrary';
import { checkGltf } from './checkGltf';
import { checkModel } from '../checkModel';
import { checkImageSize } from '../pictures/imageSize';
import { checkModelFile, modelError, readModel } from '../../assets/readModel';
import { type GltfJson, readGltfJson } from './readGltfJson';

type Json = Record<string, any>; // oxlint-disable-line typescript/no-explicit-any -- it is broken on purpose

const POSITIONS = [0, 0, 0, 1, 0, 0, 0, 1, 0];

/** A triangle with an index, under a node, with an animation, a skin, a material and a picture. */
const valid = (): Json => ({
  asset: { version: '2.0' },
  scene: 0,
  scenes: [{ nodes: [0] }],
  nodes: [{ mesh: 0, children: [1], skin: 0 }, { translation: [0, 1, 0] }],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, material: 0 }] }],
  materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
  textures: [{ source: 0 }],
  images: [{ uri: 'data:image/png;base64,AAAA' }],
  skins: [{ joints: [1] }],
  animations: [
    { samplers: [{ input: 2, output: 0 }], channels: [{ sampler: 0, target: { node: 1, path: 'translation' } }] },
  ],
  accessors: [
    { componentType: 5126, type: 'VEC3', count: 3, bufferView: 0, min: [0, 0, 0], max: [1, 1, 0] },
    { componentType: 5123, type: 'SCALAR', count: 3, bufferView: 1 },
    { componentType: 5126, type: 'SCALAR', count: 3, bufferView: 0 },
  ],
  bufferViews: [
    { buffer: 0, byteLength: 36 },
    { buffer: 0, byteOffset: 36, byteLength: 6 },
  ],
  buffers: [{ byteLength: 42 }],
});

/** The triangle without its picture, which Node cannot read. */
function plain(): Json {
  const json = valid();
  for (const key of ['skins', 'materials', 'textures', 'images', 'animations']) delete json[key];
  json.nodes = [{ mesh: 0, name: 'Wall' }];
  delete json.meshes[0].primitives[0].material;
  return json;
}

/** A GLB of the given JSON and 44 bytes. */
function glb(json: Json, positions: readonly number[] = POSITIONS): ArrayBuffer {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const length = Math.ceil(text.length / 4) * 4;
  const bytes = new ArrayBuffer(28 + length + 44);
  const view = new DataView(bytes);
  [0x46546c67, 2, bytes.byteLength, length, 0x4e4f534a].forEach((word, i) => view.setUint32(i * 4, word, true));
  new Uint8Array(bytes, 20, length).fill(0x20);
  new Uint8Array(bytes, 20).set(text);
  view.setUint32(20 + length, 44, true);
  view.setUint32(24 + length, 0x004e4942, true);
  positions.forEach((value, i) => view.setFloat32(28 + length + i * 4, value, true));
  [0, 1, 2].forEach((value, i) => view.setUint16(28 + length + 36 + i * 2, value, true));
  return bytes;
}

const check = (json: Json): number => checkModelFile(glb(json), json as GltfJson);

test('a valid file is taken, and each rule of the format that may be left out', () => {
  expect(() => check(valid())).not.toThrow();
  expect(() => check({ asset: { version: '2.0' } })).not.toThrow();
  const json = valid();
  json.accessors[0].sparse = {
    count: 1,
    indices: { bufferView: 1, componentType: 5123 },
    values: { bufferView: 0 },
  };
  json.bufferViews[0].byteStride = 12;
  json.nodes[0].extensions = { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION: 0 } } };
  expect(() => check(json)).not.toThrow();
});

test('views of the same bytes do not come to more than they may', () => {
  const json = { asset: { version: '2.0' }, buffers: [{ byteLength: 1e6 }] } as GltfJson;
  json.bufferViews = Array.from({ length: 101 }, () => ({ buffer: 0, byteLength: 1e6 }));
  expect(() => checkGltf(json, { binary: 1e6 })).toThrow(/come to 101,000,000 bytes of buffers that have 1,000,000/);
});

test('accessors of the same bytes, sparse ones too, and morph targets do not come to more than they may', () => {
  const json: Json = { asset: { version: '2.0' }, buffers: [{ byteLength: 1e6 }] };
  json.bufferViews = [{ buffer: 0, byteLength: 1e6 }];
  const accessor = { bufferView: 0, componentType: 5126, type: 'SCALAR', count: 250_000 };
  json.accessors = Array.from({ length: 101 }, () => accessor);
  const said = /its accessors come to 101,000,000 bytes of buffers that have 1,000,000/;
  expect(() => checkGltf(json as GltfJson, { binary: 1e6 })).toThrow(said);
  json.accessors = [{ bufferView: 0, componentType: 5126, type: 'VEC3', count: 80_000 }];
  const primitive = { attributes: { POSITION: 0 }, targets: Array.from({ length: 2000 }, () => ({ POSITION: 0 })) };
  json.meshes = [{ primitives: [primitive] }];
  expect(() => checkGltf(json as GltfJson, { binary: 1e6 })).toThrow(/morph targets come to 160,000,000 vertices/);
});

const chain = (count: number): Json[] =>
  Array.from({ length: count }, (_, i) => (i < count - 1 ? { children: [i + 1] } : {}));

const broken: [string, (json: Json) => void, RegExp][] = [
  [
    'an absurd count',
    (j) => (j.accessors[0].count = 4e9),
    /accessor 0 has 4,000,000,000 values, more than fit into the 36 bytes/,
  ],
  [
    'an absurd count without data',
    (j) => (j.accessors[0] = { componentType: 5126, type: 'VEC3', count: 4e9 }),
    /48,000,000,000 bytes of zeros/,
  ],
  ['a count below 0', (j) => (j.accessors[0].count = -1), /the count of accessor 0 must be a whole number/],
  ['a count that is text', (j) => (j.accessors[0].count = '3'), /the count of accessor 0 .* not "3"/],
  ['a type that is none', (j) => (j.accessors[0].type = 'VEC5'), /accessor 0 has an unknown type/],
  ['a type of all objects', (j) => (j.accessors[0].type = 'constructor'), /accessor 0 has an unknown type/],
  ['a component that is none', (j) => (j.accessors[0].componentType = 5124), /accessor 0 has an unknown type/],
  ['an offset beyond', (j) => (j.accessors[0].byteOffset = 4), /accessor 0 has 3 values, more than fit/],
  ['a stride beyond', (j) => (j.bufferViews[0].byteStride = 24), /accessor 0 has 3 values, more than fit/],
  ['an absurd stride', (j) => (j.bufferViews[0].byteStride = 1e9), /more than 252 bytes/],
  [
    'a view beyond its buffer',
    (j) => (j.bufferViews[0].byteLength = 43),
    /buffer view 0 ends at byte 43 of a buffer of 42/,
  ],
  ['a buffer beyond the file', (j) => (j.buffers[0].byteLength = 1e9), /buffer 0 says 1,000,000,000 bytes, and has 44/],
  ['a second buffer without bytes', (j) => j.buffers.push({ byteLength: 9 }), /buffer 1 says 9 bytes, and has 0/],
  ['a sparse count', (j) => (j.accessors[0].sparse = { count: 4e9 }), /changes more values than it has/],
  [
    'a sparse view',
    (j) => (j.accessors[0].sparse = { count: 3, indices: { bufferView: 9 }, values: {} }),
    /accessor 0 names the buffer view 9, and there are 2/,
  ],
  [
    'meshopt',
    (j) =>
      (j.bufferViews[1].extensions = {
        EXT_meshopt_compression: { buffer: 0, byteLength: 6, byteStride: 4, count: 1e9 },
      }),
    /would be unpacked from 6 to 4,000,000,000 bytes/,
  ],
  ['a mesh that is not there', (j) => (j.nodes[0].mesh = 7), /node 0 names the mesh 7, and there are 1/],
  [
    'an accessor that is not there',
    (j) => (j.meshes[0].primitives[0].attributes.POSITION = 9),
    /mesh 0 names the accessor 9/,
  ],
  ['no primitives', (j) => delete j.meshes[0].primitives, /the primitives of mesh 0 must be a list/],
  ['a mode that is none', (j) => (j.meshes[0].primitives[0].mode = 9), /unknown mode 9/],
  ['a child that is not there', (j) => (j.nodes[0].children = [5]), /node 0 names the node 5/],
  ['a node below itself', (j) => (j.nodes[1].children = [0]), /node 0 is below itself/],
  [
    'a node below two',
    (j) => {
      j.nodes.push({ children: [1] });
    },
    /node 1 is below two others, 0 and 2/,
  ],
  [
    'nodes too deep',
    (j) => {
      j.nodes = chain(501);
      j.skins = [];
      j.animations = [];
    },
    /nodes are more than 500 deep/,
  ],
  ['a scale that is none', (j) => (j.nodes[1].scale = [1, 'a', 1]), /the scale of node 1 holds "a"/],
  [
    'an absurd scale',
    (j) => (j.nodes[1].scale = [1e30, 1, 1]),
    /the scale of node 1 holds 1e\+30, and 1000000000000 is the limit/,
  ],
  [
    'an absurd scale in steps',
    (j) => {
      j.nodes[0].scale = [1e7, 1e7, 1e7];
      j.nodes[1].scale = [1e7, 1e7, 1e7];
    },
    /node 1 is scaled or moved beyond/,
  ],
  ['a matrix of three', (j) => (j.nodes[1].matrix = [1, 2, 3]), /must have 16 numbers, not 3/],
  [
    'very many draws',
    (j) => {
      j.meshes[0].primitives = Array.from({ length: 2000 }, () => ({ attributes: {} }));
      j.nodes = Array.from({ length: 600 }, () => ({ mesh: 0 }));
      j.skins = [];
      j.animations = [];
    },
    /take 1,200,000 draw calls, and 1,000,000 is the limit/,
  ],
  [
    'morph targets of one accessor',
    (j) => (j.meshes[0].primitives[0].targets = Array.from({ length: 3000 }, () => ({ POSITION: 0 }))),
    /3,000 morph targets, and 2,048 is the limit/,
  ],
  [
    'instances of absurd count',
    (j) => {
      j.accessors.push({ componentType: 5121, type: 'SCALAR', count: 4e7 });
      j.nodes[0].extensions = { EXT_mesh_gpu_instancing: { attributes: { _ID: 3 } } };
    },
    /draw 120,000,000 vertices/,
  ],
  ['a skin without joints', (j) => delete j.skins[0].joints, /the joints of skin 0 must be a list/],
  [
    'too few matrices',
    (j) => (j.skins[0] = { joints: Array(9).fill(1), inverseBindMatrices: 0 }),
    /more joints than matrices/,
  ],
  ['a name that is no text', (j) => (j.nodes[1].name = []), /the name of node 1 must be a text/],
  ['a channel without a target', (j) => delete j.animations[0].channels[0].target, /channel without a target/],
  ['a sampler that is not there', (j) => (j.animations[0].channels[0].sampler = 3), /animation 0 names the sampler 3/],
  [
    'a texture that is not there',
    (j) => (j.materials[0].normalTexture = { index: 4 }),
    /material 0 names the texture 4/,
  ],
  ['an image that is not there', (j) => (j.textures[0].source = 4), /texture 0 names the image 4/],
  ['an image of nothing', (j) => (j.images[0] = {}), /image 0 has neither/],
  ['a list that is none', (j) => (j.nodes = { length: 4e9 }), /'nodes' must be a list, not an object/],
  ['an entry that is none', (j) => (j.accessors[1] = null), /accessor 1 is no object/],
  ['a scene that is not there', (j) => (j.scene = 3), /the file names the scene 3/],
  ['a scene of one node twice', (j) => (j.scenes[0].nodes = [0, 0]), /scene 0 names a node twice/],
  ['deep extras', (j) => (j.extras = JSON.parse('['.repeat(5000) + ']'.repeat(5000))), /more than 128 lists/],
];

describe('what is wrong with a model is said in one sentence before memory is taken', () => {
  test.each(broken)('%s', async (_, change, message) => {
    const json = valid();
    change(json);
    expect(() => check(json)).toThrow(message);
    await expect(readModel(glb(json))).rejects.toThrow(/^[^\n]{10,300}: export it again\.$/);
  });

  test('positions that are not numbers, or absurd', async () => {
    const file = (positions: number[]): ArrayBuffer => glb(plain(), positions);
    expect((await readModel(file(POSITIONS))).scene.children).toHaveLength(1);
    await expect(readModel(file([NaN, 0, 0]))).rejects.toThrow(/^the mesh 'Wall' has positions that are not numbers/);
    await expect(readModel(file([1e30, 0, 0]))).rejects.toThrow(/^the mesh 'Wall' reaches beyond 1000000000000 m/);
  });

  test('a scale that makes positions absurd', async () => {
    const geometry = new BufferGeometry().setAttribute('position', new Float32BufferAttribute([0, 0, 1e8], 3));
    const scene = new Group().add(new Mesh(geometry));
    await checkModel(scene);
    scene.scale.setScalar(1e6);
    await expect(checkModel(scene)).rejects.toThrow(/a mesh reaches beyond/);
  });

  test('a file without scenes is all of its nodes, or its meshes', async () => {
    const json = plain();
    json.nodes = [{ name: 'Below' }, { name: 'Wall', mesh: 0, children: [0] }, { name: 'Beside' }];
    delete json.scene;
    for (const scenes of [undefined, []]) {
      const { scene } = await readModel(glb({ ...json, scenes }));
      expect(scene.children.map(({ name }) => name)).toEqual(['Wall', 'Beside']);
      expect(scene.children[0].children.map(({ name }) => name)).toContain('Below');
    }
    const alone = await readModel(glb({ ...plain(), scene: undefined, scenes: undefined, nodes: undefined }));
    expect(alone.scene.children).toHaveLength(1);
    expect((await readModel(glb({ asset: { version: '2.0' } }))).scene.children).toEqual([]);
  });

  test('what an engine or a loader throws', () => {
    expect(modelError(new TypeError("Cannot read properties of undefined (reading 'count')")).message).toBe(
      "three's loader cannot read it (Cannot read properties of undefined (reading 'count')): export it again.",
    );
    expect(modelError(new Error('THREE.GLTFLoader: Unsupported asset.')).message).toMatch(/\(Unsupported asset\.\)/);
    expect(modelError(new Error('x'.repeat(1e6))).message.length).toBeLessThan(300);
  });

  test('a version that is an object', () => {
    const bytes = new TextEncoder().encode(JSON.stringify({ asset: { version: 'z'.repeat(1e5) } }));
    expect(() => readGltfJson(bytes.buffer as ArrayBuffer)).toThrow(/^it is glTF z{39}…/);
  });
});

describe('pictures', () => {
  const png = (width: number, height: number): Uint8Array => {
    const bytes = new Uint8Array(40);
    bytes.set([0x89, 0x50, 0x4e, 0x47]);
    new DataView(bytes.buffer).setUint32(16, width);
    new DataView(bytes.buffer).setUint32(20, height);
    return bytes;
  };

  test('of absurd size are not decoded, in a model either', async () => {
    expect(() => checkImageSize(png(8192, 8192))).not.toThrow();
    expect(() => checkImageSize(png(60_000, 60_000))).toThrow(/60000 × 60000 pixels/);
    expect(() => checkImageSize(png(16_384, 16_384))).toThrow(/128 million in all/);
    const json = valid();
    json.images[0].uri = `data:image/png;base64,${Buffer.from(png(60_000, 60_000)).toString('base64')}`;
    await expect(readModel(glb(json))).rejects.toThrow(/60000 × 60000 pixels/);
  });

  test('of absurd size are found wherever a model has them', async () => {
    const absurd = png(60_000, 60_000);
    const base64 = Buffer.from(absurd).toString('base64');
    const percent = [...absurd].map((byte) => `%${byte.toString(16).padStart(2, '0')}`).join('');
    // 80 kB of metadata before the JPEG's size
    const segment = [0xff, 0xe1, 0x9c, 0x40, ...Array.from({ length: 0x9c40 - 2 }, () => 0)];
    const frame = [0xff, 0xc0, 0, 11, 8, 0xff, 0x00, 0xff, 0x00, ...Array.from({ length: 20 }, () => 0)];
    const jpeg = Buffer.from([0xff, 0xd8, ...segment, ...segment, ...frame]).toString('base64');
    for (const uri of [
      `data:image/png;charset=x;base64,\n ${base64}`,
      `data:image/png,${percent}`,
      `data:image/jpeg;base64,${jpeg}`,
      `data:image/png;base64,${base64.replaceAll('+', '%2B').replaceAll('=', '%3D')}`,
    ]) {
      const json = valid();
      json.images[0].uri = uri;
      await expect(readModel(glb(json))).rejects.toThrow(/\d{5} × \d{5} pixels/);
    }
    // embedded in a buffer of a .gltf
    const json = valid();
    json.buffers.push({ byteLength: 40, uri: `data:application/octet-stream;base64,${base64}` });
    json.bufferViews.push({ buffer: 1, byteLength: 40 });
    json.images = [{ bufferView: 2, mimeType: 'image/png' }];
    await expect(readModel(glb(json))).rejects.toThrow(/60000 × 60000 pixels/);
    json.buffers = [{ byteLength: 42, uri: `data:,${'%00'.repeat(42)}` }, json.buffers[1]];
    const text = new TextEncoder().encode(JSON.stringify(json)).buffer as ArrayBuffer;
    await expect(readModel(text)).rejects.toThrow(/60000 × 60000 pixels/);
  });
});

test('a load that is cancelled ends at once; what comes after it is given back, and the asset can be loaded again', async () => {
  const assets = new AssetLibrary();
  assets.registerFile('wall.glb', new Blob([glb(plain())]));
  const before = assets.list();
  const told: string[] = [];
  assets.onChange(({ kind }) => told.push(kind));
  const control = new AbortController();
  const loading = assets.load('wall.glb', control.signal);
  control.abort();
  await expect(loading).rejects.toMatchObject({ name: 'AbortError' });
  expect([assets.list(), assets.isReady('model', 'wall.glb'), told]).toEqual([before, false, []]);
  await assets.load('wall.glb');
  expect(told).toEqual(['loaded']);
});
