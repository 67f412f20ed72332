import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { checkModelFile } from '../../assets/readModel';
import { binaryOf, readGltfJson } from '../../guard/gltf/readGltfJson';
import { packObj } from '../packObj';
import { roughnessOf } from './gltfOfMtl';
import { parseMtl, parseMtlMap } from './parseMtl';
import { tga } from './testing/tga';

interface Material {
  name: string;
  pbrMetallicRoughness: {
    baseColorFactor: number[];
    metallicFactor: number;
    roughnessFactor: number;
    baseColorTexture?: { index: number; extensions?: object };
    metallicRoughnessTexture?: { index: number };
  };
  normalTexture?: { index: number; scale?: number };
  emissiveFactor?: number[];
  emissiveTexture?: { index: number };
  extensions?: Record<string, Record<string, number>>;
  alphaMode?: string;
  doubleSided?: boolean;
}
interface Json {
  extensionsUsed?: string[];
  materials: Material[];
  images?: { name: string; mimeType: string; bufferView: number }[];
  textures?: { source: number; sampler: number }[];
  nodes: { name: string; mesh: number }[];
  meshes: { primitives: { attributes: Record<string, number>; indices: number; material: number }[] }[];
  accessors: { bufferView: number; count: number; min?: number[]; max?: number[]; componentType: number }[];
  bufferViews: { byteOffset: number; byteLength: number }[];
}

const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n';
const face = 'f 1/1 2/2 3/3 4/4\n';

const plain = (...texel: number[]): Uint8Array<ArrayBuffer> =>
  tga(
    2,
    2,
    Array.from({ length: 4 }, () => texel),
  );
/** The first bytes of a PNG, by which it is recognised. */
const png = Uint8Array.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]);

const filesOf = (entries: Record<string, string | Uint8Array<ArrayBuffer>>) =>
  new Map(Object.entries(entries).map(([path, content]) => [path, new File([content], path.split('/').pop()!)]));

async function pack(entries: Record<string, string | Uint8Array<ArrayBuffer>>, path = 'a.obj') {
  const packed = await packObj(filesOf(entries), path);
  const json = readGltfJson(packed.glb);
  checkModelFile(packed.glb, json);
  return { ...packed, json: json as unknown as Json, binary: binaryOf(packed.glb)! };
}

/** The only material that an MTL text gives. */
async function materialOf(mtl: string, files: Record<string, Uint8Array<ArrayBuffer>> = {}) {
  const packed = await pack({
    'a.obj': `mtllib a.mtl\n${square}usemtl m\n${face}`,
    'a.mtl': `newmtl m\n${mtl}`,
    ...files,
  });
  return { ...packed, material: packed.json.materials[0] };
}

beforeEach(() => {
  // Node decodes no images: here each one that is recognised counts as decoded
  vi.stubGlobal('createImageBitmap', async () => ({ close() {} }));
});
afterEach(() => vi.unstubAllGlobals());

describe('packObj', () => {
  it('makes a GLB of vertices, each once, with v from the top', async () => {
    const { json, binary } = await pack({ 'a.obj': `${square}vn 0 0 2\nf 1/1/1 2/2/1 3/3/1 4/4/1` });
    const [primitive] = json.meshes[0].primitives;
    const floats = (name: string): number[] => {
      const { byteOffset, byteLength } = json.bufferViews[json.accessors[primitive.attributes[name]].bufferView];
      return [...new Float32Array(binary.slice(byteOffset, byteOffset + byteLength).buffer)];
    };
    expect(floats('POSITION')).toEqual([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
    expect(floats('NORMAL')).toEqual(Array.from({ length: 4 }, () => [0, 0, 1]).flat());
    expect(floats('TEXCOORD_0')).toEqual([0, 1, 1, 1, 1, 0, 0, 0]);
    const { byteOffset, byteLength } = json.bufferViews[json.accessors[primitive.indices].bufferView];
    expect([...new Uint16Array(binary.slice(byteOffset, byteOffset + byteLength).buffer)]).toEqual([0, 1, 2, 0, 2, 3]);
    expect(json.accessors[primitive.attributes.POSITION]).toMatchObject({ min: [0, 0, 0], max: [1, 1, 0] });
  });

  it('computes missing normals by crease angle, across groups and materials', async () => {
    // two faces that meet at 20°, in two groups, and a third at 90°
    const bend = (20 * Math.PI) / 180;
    const end = `${1 + Math.cos(bend)} ${Math.sin(bend)}`;
    const text = `v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nv ${end} 0\nv ${end} 1\nv 0 1 0\nv 0 1 1\ng a\nf 4 3 2 1\ng b\nusemtl x\nf 3 6 5 2\ng c\nf 1 7 8 4`;
    const { json, binary } = await pack({ 'a.obj': text });
    const normalsAt = (mesh: number, place: readonly number[]): number[][] => {
      const { attributes } = json.meshes[mesh].primitives[0];
      const [positions, normals] = ['POSITION', 'NORMAL'].map((name) => {
        const { byteOffset, byteLength } = json.bufferViews[json.accessors[attributes[name]].bufferView];
        return new Float32Array(binary.slice(byteOffset, byteOffset + byteLength).buffer);
      });
      return Array.from({ length: positions.length / 3 }, (_, i) => i * 3)
        .filter((at) => place.every((value, k) => positions[at + k] === value))
        .map((at) => [...normals.slice(at, at + 3)]);
    };
    const [smooth] = normalsAt(0, [1, 0, 0]);
    expect(smooth[0]).toBeCloseTo(-Math.sin(bend / 2), 5);
    expect(normalsAt(1, [1, 0, 0])[0]).toEqual(smooth);
    // the third meets the first at 90°: an edge
    expect(normalsAt(0, [0, 0, 0])[0][1]).toBeCloseTo(1, 5);
    expect(normalsAt(2, [0, 0, 0])[0][0]).toBeCloseTo(1, 5);
  });

  it('keeps normals of a file and completes those that are missing or have no length', async () => {
    const { json, binary } = await pack({ 'a.obj': `${square}vn 1 0 0\nvn 0 0 0\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2` });
    const { attributes } = json.meshes[0].primitives[0];
    const { byteOffset, byteLength } = json.bufferViews[json.accessors[attributes.NORMAL].bufferView];
    const normals = new Float32Array(binary.slice(byteOffset, byteOffset + byteLength).buffer);
    const list = Array.from({ length: normals.length / 3 }, (_, i) => normals.slice(i * 3, i * 3 + 3).join());
    expect(list.filter((each) => each === '1,0,0')).toHaveLength(3);
    expect(list.filter((each) => each === '0,0,1')).toHaveLength(3);
  });

  it('makes a mesh of each group, a primitive of each material, and few meshes of very many groups', async () => {
    const two = await pack({ 'a.obj': `${square}g one\nusemtl x\n${face}usemtl y\n${face}g two\n${face}` });
    expect(two.json.nodes.map(({ name }) => name)).toEqual(['one', 'two']);
    expect(two.json.meshes.map(({ primitives }) => primitives.map(({ material }) => material))).toEqual([[0, 1], [1]]);
    const groups = Array.from({ length: 4001 }, (_, i) => `g ${i}\nf 1//1 2//1 3//1\n`).join('');
    const many = await pack({ 'a.obj': `${square}vn 0 0 1\n${groups}` });
    expect(many.json.meshes).toHaveLength(1);
    expect(many.json.nodes[0].name).toBe('a');
  });

  it('is grey without its MTL, and says so once', async () => {
    const { json, notes } = await pack({ 'a.obj': `mtllib a.mtl\n${square}usemtl wall\n${face}usemtl roof\n${face}` });
    expect(notes).toEqual([
      'a.obj: it is grey, since its materials were not found: a.mtl. Drop them together with it.',
    ]);
    expect(json.materials.map(({ name }) => name)).toEqual(['wall', 'roof']);
    expect((await pack({ 'a.obj': square + face })).notes).toEqual([
      'a.obj: it is grey, since it names no file of materials. Drop its MTL file with it.',
    ]);
  });

  it('names the materials that no MTL has, and what it left out', async () => {
    const { notes } = await pack({
      'a.obj': `mtllib a.mtl\n${square}usemtl wall\n${face}usemtl Ümlaut\n${face}l 1 2\n`,
      'a.mtl': 'newmtl wall\nKd 1 0 0',
    });
    expect(notes).toEqual([
      'a.obj: these materials are in no MTL file and stay grey: Ümlaut.',
      'a.obj: its lines, points and curves were left out.',
    ]);
  });

  it('finds files by other case, backslashes, other folders, blanks and other endings', async () => {
    const mtl = [
      'newmtl a\nmap_Kd Textures\\Wall Stone.PNG',
      'newmtl b\nmap_Kd C:\\Users\\me\\textures\\roof.tga',
      'newmtl c\nmap_Kd ..\\sponza\\textures\\floor.png',
      'newmtl d\nmap_Kd "textures/b/same.png"',
      'newmtl e\nmap_Kd gone.png\nmap_bump textures\\gone too.jpg',
    ].join('\n');
    const faces = ['a', 'b', 'c', 'd', 'e'].map((name) => `usemtl ${name}\n${face}`).join('');
    const packed = await pack(
      {
        'sponza/sponza.obj': `mtllib .\\Sponza.mtl\n${square}${faces}`,
        'sponza/sponza.MTL': mtl,
        'sponza/textures/wall stone.png': png,
        'sponza/textures/ROOF.png': png,
        'sponza/textures/floor.png': png,
        'sponza/textures/a/same.png': png,
        'sponza/textures/b/same.png': png,
        'sponza/unused.png': png,
      },
      'sponza/sponza.obj',
    );
    expect(packed.json.images!.map(({ name }) => name)).toEqual([
      'wall stone.png',
      'ROOF.png',
      'floor.png',
      'same.png',
    ]);
    expect([...packed.used].sort()).toEqual([
      'sponza/sponza.MTL',
      'sponza/textures/ROOF.png',
      'sponza/textures/b/same.png',
      'sponza/textures/floor.png',
      'sponza/textures/wall stone.png',
    ]);
    expect(packed.notes).toEqual([
      'sponza.obj: these textures were not found: gone.png, textures/gone too.jpg. Drop the whole folder, or all files together.',
    ]);
  });

  it('takes several MTL files, and the one beside it where none is named', async () => {
    const obj = `mtllib a.mtl b.mtl\n${square}usemtl one\n${face}usemtl two\n${face}`;
    const both = await pack({ 'a.obj': obj, 'a.mtl': 'newmtl one\nKd 1 0 0', 'b.mtl': 'newmtl two\nKd 0 1 0' });
    expect(both.json.materials.map(({ pbrMetallicRoughness: { baseColorFactor } }) => baseColorFactor)).toEqual([
      [1, 0, 0, 1],
      [0, 1, 0, 1],
    ]);
    const beside = await pack({ 'a.obj': `${square}usemtl one\n${face}`, 'other.mtl': 'newmtl one\nKd 0 0 1' });
    expect(beside.json.materials[0].pbrMetallicRoughness.baseColorFactor).toEqual([0, 0, 1, 1]);
    expect(beside.notes).toEqual([]);
  });

  it('stops when it is cancelled', async () => {
    const control = new AbortController();
    control.abort(new Error('cancelled'));
    const lines = Array.from({ length: 30_000 }, () => face).join('');
    await expect(packObj(filesOf({ 'a.obj': square + lines }), 'a.obj', control.signal)).rejects.toThrow('cancelled');
  });
});

describe('a material of an MTL file', () => {
  it('has a linear colour, roughness by Ns and Ks, and is no metal', async () => {
    const { material } = await materialOf('Ns 96\nKd 0.5 1 0\nKs 1 1 1\nd 1\nTr 0\nillum 2');
    const { baseColorFactor, roughnessFactor, metallicFactor } = material.pbrMetallicRoughness;
    expect(baseColorFactor[0]).toBeCloseTo(0.214, 3);
    expect(baseColorFactor.slice(1)).toEqual([1, 0, 1]);
    expect(roughnessFactor).toBeCloseTo((2 / 98) ** 0.25, 6);
    expect(metallicFactor).toBe(0);
    expect(material).not.toHaveProperty('alphaMode');
    expect(material).not.toHaveProperty('emissiveFactor');
  });

  it('is the rougher the weaker its highlight', () => {
    expect(roughnessOf(1000, 1)).toBeLessThan(roughnessOf(10, 1));
    expect(roughnessOf(0, 1)).toBe(1);
    expect(roughnessOf(1000, 0)).toBe(1);
    expect(roughnessOf(100, 0.5)).toBeCloseTo((1 + roughnessOf(100, 1)) / 2, 10);
  });

  it('takes Pr and Pm as they are', async () => {
    const { material } = await materialOf('Ns 500\nPr 0.7\nPm 1');
    expect(material.pbrMetallicRoughness).toMatchObject({ roughnessFactor: 0.7, metallicFactor: 1 });
  });

  it('emits what Ke says, beyond 1 too', async () => {
    expect((await materialOf('Ke 0 0 0')).material).not.toHaveProperty('emissiveFactor');
    const { material, json } = await materialOf('Ke 2 0 0');
    expect(material.emissiveFactor).toEqual([1, 0, 0]);
    expect(material.extensions!.KHR_materials_emissive_strength.emissiveStrength).toBeGreaterThan(4);
    expect(json.extensionsUsed).toEqual(['KHR_materials_emissive_strength']);
    const textured = await materialOf('map_Ke glow.png', { 'glow.png': png });
    expect(textured.material).toMatchObject({ emissiveFactor: [1, 1, 1], emissiveTexture: { index: 0 } });
  });

  it.each([
    ['d 0.25', 0.25],
    ['Tr 0.25', 0.75],
    ['d 0.5\nTr 0.5', 0.5],
  ])('is see-through by %j', async (mtl, opacity) => {
    const { material } = await materialOf(mtl);
    expect(material.pbrMetallicRoughness.baseColorFactor[3]).toBe(opacity);
    expect(material).toMatchObject({ alphaMode: 'BLEND', doubleSided: true });
  });

  it.each(['Tr 1.0', 'd 0.000000', 'd 0\nTr 1'])('is opaque where %j would make it vanish', async (mtl) => {
    const { material } = await materialOf(mtl);
    expect(material).not.toHaveProperty('alphaMode');
    expect(material.pbrMetallicRoughness.baseColorFactor[3]).toBe(1);
  });

  it('multiplies map_Kd by Kd, unless that is black', async () => {
    const files = { 'x.png': png };
    const { material } = await materialOf('Kd 1 0 0\nmap_Kd x.png', files);
    expect(material.pbrMetallicRoughness).toMatchObject({
      baseColorFactor: [1, 0, 0, 1],
      baseColorTexture: { index: 0 },
    });
    const black = await materialOf('Kd 0 0 0\nmap_Kd x.png', files);
    expect(black.material.pbrMetallicRoughness.baseColorFactor).toEqual([1, 1, 1, 1]);
  });

  it('places and clamps textures by their options', async () => {
    const { material, json } = await materialOf('map_Kd -s 2 3 1 -o 0.5 0.25 -clamp on x.png', { 'x.png': png });
    const { extensions } = material.pbrMetallicRoughness.baseColorTexture!;
    expect(extensions).toEqual({ KHR_texture_transform: { offset: [0.5, 1 - 3 - 0.25], scale: [2, 3] } });
    expect(json.textures![0].sampler).toBe(1);
    expect(json.extensionsUsed).toEqual(['KHR_texture_transform']);
  });

  it('cuts out by a map_d of black and white, and blends by one of greys', async () => {
    const leaf = tga(2, 2, [
      [255, 255, 255],
      [0, 0, 0],
      [255, 255, 255],
      [0, 0, 0],
    ]);
    const cut = await materialOf('map_Kd c.tga\nmap_d d.tga', { 'c.tga': plain(255, 0, 0), 'd.tga': leaf });
    expect(cut.material).toMatchObject({ alphaMode: 'MASK', doubleSided: true });
    expect(cut.json.images).toHaveLength(1);
    const veil = await materialOf('map_Kd c.tga\nmap_d d.tga', {
      'c.tga': plain(255, 0, 0),
      'd.tga': plain(99, 99, 99),
    });
    expect(veil.material.alphaMode).toBe('BLEND');
  });

  it('takes a bump map for what it holds: normals as they are, heights as normals', async () => {
    const normals = await materialOf('map_bump -bm 0.5 n.tga', { 'n.tga': plain(128, 128, 255) });
    expect(normals.material.normalTexture).toEqual({ index: 0, scale: 0.5 });
    const heights = await materialOf('bump -bm 0.5 h.tga', { 'h.tga': plain(90, 90, 90) });
    expect(heights.material.normalTexture).toEqual({ index: 0 });
    expect((await materialOf('disp h.tga', { 'h.tga': plain(90, 90, 90) })).material).not.toHaveProperty(
      'normalTexture',
    );
    expect((await materialOf('norm n.png', { 'n.png': png })).material.normalTexture).toEqual({ index: 0 });
  });

  it('takes map_Ks as roughness', async () => {
    const { material } = await materialOf('Ks 1 1 1\nNs 100\nmap_Ks s.tga', { 's.tga': plain(255, 255, 255) });
    expect(material.pbrMetallicRoughness).toMatchObject({ roughnessFactor: 1, metallicRoughnessTexture: { index: 0 } });
  });

  it('names pictures that cannot be read, and goes without', async () => {
    const { material, notes } = await materialOf('map_Kd x.tga', { 'x.tga': Uint8Array.from([1, 2, 3]) });
    expect(material.pbrMetallicRoughness).not.toHaveProperty('baseColorTexture');
    expect(notes).toEqual(['a.obj: these textures cannot be read: x.tga. Save them anew, as PNG or JPEG.']);
  });

  it('is read by keywords of any case, tabs and breaks of all systems', () => {
    const table = parseMtl('NEWMTL a\r\n\tkd\t1 1 1\rMAP_KD\tx y.png\r\n\r\nnewmtl b c\nNs abc\n');
    expect([...table.keys()]).toEqual(['a', 'b c']);
    expect(table.get('a')).toMatchObject({ diffuse: [1, 1, 1], diffuseMap: { path: 'x y.png' } });
    expect(table.get('b c')!.shininess).toBeUndefined();
  });

  it('reads every option of a map', () => {
    const map = parseMtlMap('-blendu on -mm 0 1 -texres 256 -imfchan l -t 1 -s 4 -type sphere -bm 2 my map -o.png');
    expect(map).toEqual({ path: 'my map -o.png', scale: [4, 1], offset: [0, 0], isClamped: false, bump: 2 });
    expect(parseMtlMap('-bm 2')).toBeUndefined();
  });

  it('reads options that stand after the name, and leaves names that look like some', () => {
    expect(parseMtlMap('x.png -bm 0.5')).toMatchObject({ path: 'x.png', bump: 0.5 });
    expect(parseMtlMap('-s 2 2 my x.png -clamp on -o 0.5 -BM 3')).toEqual({
      path: 'my x.png',
      scale: [2, 2],
      offset: [0.5, 0],
      isClamped: true,
      bump: 3,
    });
    expect(parseMtlMap('"a b.png" -t 1 1 1 -imfchan r')).toMatchObject({ path: 'a b.png' });
    for (const path of ['a -bm.png', 'a -s 2.png', 'a -bm x', 'a -clamp maybe', 'a -s', 'a -type of.png'])
      expect(parseMtlMap(path)).toMatchObject({ path, bump: 1, scale: [1, 1] });
  });
});
