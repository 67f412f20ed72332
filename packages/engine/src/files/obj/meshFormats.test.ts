import { expect, it } from 'vitest';
import { binaryOf, readGltfJson } from '../../guard/gltf/readGltfJson';
import { packObj } from '../packObj';

interface Json {
  accessors: { bufferView: number; count: number }[];
  bufferViews: { byteOffset: number; byteLength: number }[];
  meshes: { primitives: { attributes: Record<string, number>; indices: number }[] }[];
  nodes: { name: string }[];
}

async function pack(name: string, content: string | Uint8Array<ArrayBuffer>) {
  const { glb, notes } = await packObj(new Map([[name, new File([content], name)]]), name);
  const json = readGltfJson(glb) as unknown as Json;
  const [{ attributes, indices }] = json.meshes[0].primitives;
  const floats = (attribute: string): number[] => {
    const { byteOffset, byteLength } = json.bufferViews[json.accessors[attributes[attribute]].bufferView];
    return [...new Float32Array(binaryOf(glb)!.slice(byteOffset, byteOffset + byteLength).buffer)];
  };
  return {
    json,
    notes,
    attributes,
    floats,
    vertices: json.accessors[attributes.POSITION].count,
    indices: json.accessors[indices].count,
  };
}

/** Corners of two triangles that form a square. */
const square = [
  [0, 0, 0],
  [1, 0, 0],
  [1, 1, 0],
  [0, 0, 0],
  [1, 1, 0],
  [0, 1, 0],
];

function binaryStl(corners: readonly number[][], said = corners.length / 3): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(84 + (corners.length / 3) * 50);
  const view = new DataView(bytes.buffer);
  view.setUint32(80, said, true);
  corners.forEach((corner, i) =>
    corner.forEach((value, k) => view.setFloat32(84 + Math.floor(i / 3) * 50 + 12 + (i % 3) * 12 + k * 4, value, true)),
  );
  return bytes;
}

const textStl = `solid square
${[0, 3]
  .map(
    (at) =>
      `facet normal 0 0 0\nouter loop\n${square
        .slice(at, at + 3)
        .map((c) => `vertex ${c.join(' ')}`)
        .join('\n')}\nendloop\nendfacet`,
  )
  .join('\n')}
endsolid square
`;

it.each([
  ['binary', binaryStl(square)],
  ['text', textStl],
  ['Text', textStl.replace('solid', 'Solid')],
  ['TEXT', `\n${textStl.toUpperCase()}`],
])('a %s STL becomes a mesh of shared vertices with normals', async (_, content) => {
  const { json, notes, vertices, indices, floats } = await pack('Part.STL', content);
  expect([vertices, indices]).toEqual([4, 6]);
  expect(floats('NORMAL')).toEqual(Array.from({ length: 4 }, () => [0, 0, 1]).flat());
  expect(json.nodes[0].name).toBe('Part');
  expect(notes).toEqual([]);
});

it.each([
  ['a.stl', 'solid', /^it is cut short/],
  ['a.stl', binaryStl(square, 9), /^its header says 9 triangles, and it is too short/],
  ['a.stl', `solid nothing at all${' '.repeat(99)}endsolid`, /^it has no triangles/],
  [
    'a.stl',
    binaryStl([
      [NaN, 0, 0],
      [1, 0, 0],
      [0, 1, 0],
    ]),
    /not numbers: export it again/,
  ],
  ['a.ply', 'ply\nformat ascii 1.0\nend_header\n', /^the PLY file has no vertices/],
])('says what is wrong with %s (%#)', async (name, content, message) => {
  await expect(pack(name, content)).rejects.toThrow(message);
});

it('a PLY keeps its colours and its normals', async () => {
  const rows = square.slice(0, 3).map((corner) => `${corner.join(' ')} 1 0 0 255 0 0`);
  const properties = ['x', 'y', 'z', 'nx', 'ny', 'nz'].map((name) => `property float ${name}`);
  const colours = ['red', 'green', 'blue'].map((name) => `property uchar ${name}`);
  const head = ['ply', 'format ascii 1.0', 'element vertex 3', ...properties, ...colours, 'element face 1'];
  const text = [...head, 'property list uchar int vertex_indices', 'end_header', ...rows, '3 0 1 2', ''].join('\n');
  const { floats } = await pack('a.ply', text);
  expect(floats('NORMAL')).toEqual([1, 0, 0, 1, 0, 0, 1, 0, 0]);
  expect(floats('COLOR_0')).toEqual([1, 0, 0, 1, 0, 0, 1, 0, 0]);
});
