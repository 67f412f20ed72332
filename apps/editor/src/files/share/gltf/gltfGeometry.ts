import { BufferAttribute, BufferGeometry, type InterleavedBufferAttribute, Vector3 } from 'three';
import { tangentsOf } from './tangentsOf';

/** Attributes of a mesh that its material needs. */
export interface GeometryUse {
  readonly vertexColours: boolean;
  /** Whether each face has one normal. */
  readonly flat: boolean;
  /** Whether tangents are needed, for normal maps; existing ones are kept. */
  readonly tangents: boolean;
  /** Whether only the edges of triangles are exported, for wireframes. */
  readonly edges: boolean;
}

type Attribute = BufferAttribute | InterleavedBufferAttribute;

const known = /^(position|normal|tangent|uv\d?|color|skinIndex|skinWeight)$/;
const normal = new Vector3();

/** Normals normalised, as glTF requires; the same object if they are already. */
function unitNormals(attribute: Attribute): Attribute {
  let copy: BufferAttribute | null = null;
  for (let i = 0; i < attribute.count; i++) {
    normal.fromBufferAttribute(attribute, i);
    const length = normal.length();
    if (Math.abs(length - 1) <= 0.0005) continue;
    copy ??= copyOf(attribute);
    if (length > 0) normal.divideScalar(length);
    else normal.set(0, 1, 0);
    copy.setXYZ(i, normal.x, normal.y, normal.z);
  }
  return copy ?? attribute;
}

/** Copies an attribute into one of floats. */
function copyOf(attribute: Attribute): BufferAttribute {
  const { count, itemSize } = attribute;
  const copy = new BufferAttribute(new Float32Array(count * itemSize), itemSize);
  for (let i = 0; i < count; i++) {
    for (let part = 0; part < itemSize; part++) copy.setComponent(i, part, attribute.getComponent(i, part));
  }
  return copy;
}

/** Joint indices with 0 where the weight is 0, as glTF requires; the same object if they are already. */
function neededJoints(joints: Attribute, weights: Attribute): Attribute {
  let copy: BufferAttribute | null = null;
  for (let i = 0; i < joints.count; i++) {
    for (let part = 0; part < 4; part++) {
      if (weights.getComponent(i, part) !== 0 || joints.getComponent(i, part) === 0) continue;
      if (!copy) {
        copy = new BufferAttribute(new Uint16Array(joints.count * 4), 4);
        for (let j = 0; j < joints.count; j++) {
          for (let each = 0; each < 4; each++) copy.setComponent(j, each, joints.getComponent(j, each));
        }
      }
      copy.setComponent(i, part, 0);
    }
  }
  return copy ?? joints;
}

/** Edges of triangles, each once, as pairs of vertex indices. */
function edgesOf(geometry: BufferGeometry): number[] {
  const { index } = geometry;
  const count = index ? index.count : geometry.getAttribute('position').count;
  const vertex = (at: number): number => (index ? index.getX(at) : at);
  const seen = new Set<string>();
  const edges: number[] = [];
  for (let first = 0; first + 2 < count; first += 3) {
    for (let side = 0; side < 3; side++) {
      const [a, b] = [vertex(first + side), vertex(first + ((side + 1) % 3))];
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      if (seen.has(key)) continue;
      seen.add(key);
      edges.push(a, b);
    }
  }
  return edges;
}

/** Copies a geometry, with one normal per face. */
function withFaces(source: BufferGeometry): BufferGeometry {
  const faces = source.index ? source.toNonIndexed() : source.clone();
  faces.deleteAttribute('tangent');
  faces.deleteAttribute('normal');
  faces.computeVertexNormals();
  return faces;
}

/** Converts a geometry for glTF: supported attributes, unit normals; arrays are shared. Null when it is empty. */
export function gltfGeometry(given: BufferGeometry, use: GeometryUse): BufferGeometry | null {
  const position = given.getAttribute('position') as Attribute | undefined;
  if (!position || position.count === 0 || given.index?.count === 0) return null;
  const source = use.flat ? withFaces(given) : given;
  const geometry = new BufferGeometry();
  for (const [name, attribute] of Object.entries(source.attributes) as [string, Attribute][]) {
    if (!known.test(name) || (name === 'color' && !use.vertexColours)) continue;
    if (name === 'normal') geometry.setAttribute(name, unitNormals(attribute));
    else if (name === 'skinIndex') {
      geometry.setAttribute(name, neededJoints(attribute, source.getAttribute('skinWeight')));
    } else geometry.setAttribute(name, attribute);
  }
  geometry.morphAttributes = source.morphAttributes;
  geometry.morphTargetsRelative = source.morphTargetsRelative;
  for (const { start, count, materialIndex } of source.groups) geometry.addGroup(start, count, materialIndex);
  geometry.setIndex(use.edges ? edgesOf(source) : source.index);
  const { normal: normals, uv, tangent } = geometry.attributes;
  if (use.tangents && !use.edges && normals && uv && !tangent) geometry.setAttribute('tangent', tangentsOf(geometry));
  return geometry;
}
