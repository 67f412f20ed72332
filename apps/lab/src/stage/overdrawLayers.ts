import { type Camera, Matrix4, Mesh, MeshStandardMaterial, PlaneGeometry, Vector3 } from 'three';

/** Size of a layer relative to the picture. */
const MARGIN = 1.05;

/**
 * Lit quads that cover the picture one behind the other. They are drawn first and from back to front, so that the depth
 * test discards none. They are in the farther half of the lights' depths, so that lights are in front of them.
 *
 * @param count - number of layers
 * @param places - world positions of the lights
 */
export function overdrawLayers(count: number, camera: Camera, places: readonly Vector3[]): Mesh[] {
  camera.updateMatrixWorld(true);
  const inverse = new Matrix4().copy(camera.matrixWorld).invert();
  const depths = places.map((place) => -place.clone().applyMatrix4(inverse).z).sort((a, b) => a - b);
  const { near, far } = camera as Camera & { near: number; far: number };
  const within = (depth: number): number => Math.min(Math.max(depth, near * 2), far * 0.9);
  const front = within(depths[depths.length >> 1] ?? 10);
  const back = Math.max(within(depths[depths.length - 1] ?? 20), front * 1.2);
  const geometry = new PlaneGeometry(2 * MARGIN, 2 * MARGIN);
  const material = new MeshStandardMaterial({ color: 0xb8b8b8, roughness: 0.7, metalness: 0 });
  return Array.from({ length: count }, (_, i) => {
    const depth = count === 1 ? front : back + ((front - back) * i) / (count - 1);
    const corner = new Vector3(1, 1, depthOf(camera, depth)).applyMatrix4(camera.projectionMatrixInverse);
    const layer = new Mesh(geometry, material);
    layer.name = `Layer ${i + 1}`;
    layer.renderOrder = i - count;
    layer.matrixAutoUpdate = false;
    layer.matrix
      .makeScale(corner.x, corner.y, 1)
      .premultiply(new Matrix4().makeTranslation(0, 0, -depth))
      .premultiply(camera.matrixWorld);
    return layer;
  });
}

/** Depth in normalised device coordinates at a distance along the view direction (m). */
const depthOf = (camera: Camera, distance: number): number =>
  new Vector3(0, 0, -distance).applyMatrix4(camera.projectionMatrix).z;
