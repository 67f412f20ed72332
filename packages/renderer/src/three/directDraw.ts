import type { BufferGeometry, Camera, Material, Object3D, Scene, WebGLRenderer } from 'three';
import type { GeometryGroup } from './RenderListItem';

/** three's `renderBufferDirect`, which draws without a scene and without groups too. */
export type DirectDraw = (
  camera: Camera,
  scene: Scene | null,
  geometry: BufferGeometry,
  material: Material,
  object: Object3D,
  group: GeometryGroup | null,
) => void;

/** Returns the function by which a renderer draws one object with one material, inside its own `render`. */
export function directDraw(webgl: WebGLRenderer): DirectDraw {
  return webgl.renderBufferDirect as unknown as DirectDraw;
}
