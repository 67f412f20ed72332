import { BufferAttribute, type BufferGeometry, Vector3 } from 'three';

const [edge1, edge2, direction, normal, tangent] = Array.from({ length: 5 }, () => new Vector3());

/**
 * Tangents along u as [x, y, z, w], where w is the sign of the bitangent; in glTF the bitangent is against v, like
 * green of its normal maps. Vertices with degenerate texture coordinates get an arbitrary tangent.
 * @param geometry - with normals and texture coordinates
 * @see glTF 2.0, 3.7.2.1; Lengyel, "Computing tangent space basis vectors for an arbitrary mesh", 2001
 */
export function tangentsOf(geometry: BufferGeometry): BufferAttribute {
  const { index } = geometry;
  const [position, normals, uv] = ['position', 'normal', 'uv'].map((name) => geometry.getAttribute(name));
  const { count } = position;
  const alongU = new Float32Array(count * 3);
  const alongV = new Float32Array(count * 3);
  const corners = index ? index.count : count;
  for (let first = 0; first + 2 < corners; first += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => (index ? index.getX(first + corner) : first + corner));
    edge1.fromBufferAttribute(position, b).sub(direction.fromBufferAttribute(position, a));
    edge2.fromBufferAttribute(position, c).sub(direction);
    const [u1, v1] = [uv.getX(b) - uv.getX(a), uv.getY(b) - uv.getY(a)];
    const [u2, v2] = [uv.getX(c) - uv.getX(a), uv.getY(c) - uv.getY(a)];
    const area = u1 * v2 - u2 * v1;
    if (area === 0 || !Number.isFinite(1 / area)) continue;
    add(
      alongU,
      direction
        .copy(edge1)
        .multiplyScalar(v2 / area)
        .addScaledVector(edge2, -v1 / area),
      a,
      b,
      c,
    );
    add(
      alongV,
      direction
        .copy(edge2)
        .multiplyScalar(u1 / area)
        .addScaledVector(edge1, -u2 / area),
      a,
      b,
      c,
    );
  }
  const data = new Float32Array(count * 4);
  for (let i = 0; i < count; i++) {
    normal.fromBufferAttribute(normals, i);
    tangent.fromArray(alongU, i * 3);
    tangent.addScaledVector(normal, -normal.dot(tangent));
    if (!(tangent.lengthSq() > 1e-20)) {
      tangent.set(1, 0, 0).addScaledVector(normal, -normal.x);
      if (tangent.lengthSq() < 0.1) tangent.set(0, 0, 1).addScaledVector(normal, -normal.z);
    }
    tangent.normalize().toArray(data, i * 4);
    const isMirrored = direction.crossVectors(normal, tangent).dot(edge1.fromArray(alongV, i * 3)) < 0;
    data[i * 4 + 3] = isMirrored ? 1 : -1;
  }
  return new BufferAttribute(data, 4);
}

function add(to: Float32Array, value: Vector3, ...vertices: number[]): void {
  for (const vertex of vertices) {
    to[vertex * 3] += value.x;
    to[vertex * 3 + 1] += value.y;
    to[vertex * 3 + 2] += value.z;
  }
}
