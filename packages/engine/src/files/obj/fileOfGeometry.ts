import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three';
import { inSteps, type Steps } from '../../base/steps';
import { weldPositions } from '../../geometry/weldPositions';
import type { ObjFile } from './parseObj';

/**
 * A triangle geometry in the form of an OBJ file: one group without a material. Vertices of a non-indexed geometry are
 * merged by position, since files without an index repeat shared vertices.
 * @param hasNormals - whether to keep its normals; otherwise normals are computed by crease angle
 */
export function* fileOfGeometry(geometry: BufferGeometry, hasNormals: boolean): Steps<ObjFile> {
  const { index } = geometry;
  const position = geometry.getAttribute('position');
  const places = index ? null : (yield* weldPositions(position)).places;
  const normal = hasNormals ? geometry.getAttribute('normal') : undefined;
  const uv = geometry.getAttribute('uv');
  const colour = geometry.getAttribute('color');
  const count = index ? index.count : position.count;
  const whole = count - (count % 3);
  const corners = new Int32Array(whole * 3);
  const positions = new Float32Array(position.count * 3);
  yield* inSteps(whole, (from, to) => {
    for (let corner = from; corner < to; corner++) {
      const vertex = index ? index.getX(corner) : corner;
      // vertices at one position are merged, unless the geometry has colours, in which they may differ
      const place = places && !colour ? places[vertex] : vertex;
      corners[corner * 3] = place;
      corners[corner * 3 + 1] = uv ? vertex : -1;
      corners[corner * 3 + 2] = normal ? vertex : -1;
      positions.set([position.getX(vertex), position.getY(vertex), position.getZ(vertex)], place * 3);
    }
  });
  return {
    positions,
    colours: colour ? yield* valuesOf(colour, 3) : null,
    uvs: uv ? yield* valuesOf(uv, 2) : new Float32Array(),
    normals: normal ? yield* valuesOf(normal, 3) : new Float32Array(),
    corners,
    runs: [{ name: '', key: '', material: null, from: 0, to: whole }],
    materialFiles: [],
    leftOut: 0,
    coarse: 0,
  };
}

/** Values of an attribute of any component type as floats. */
function* valuesOf(attribute: BufferAttribute | InterleavedBufferAttribute, size: number): Steps<Float32Array> {
  const values = new Float32Array(attribute.count * size);
  yield* inSteps(attribute.count, (from, to) => {
    for (let i = from; i < to; i++) for (let k = 0; k < size; k++) values[i * size + k] = attribute.getComponent(i, k);
  });
  return values;
}
