import type { BufferGeometry, Camera, Material, Object3D, Scene, WebGLRenderer } from 'three';
import type { GeometryGroup } from './RenderListItem';

/** three's `renderBufferDirect`, which also draws without a scene or group. */
export type DirectDraw = (
  camera: Camera,
  scene: Scene | null,
  geometry: BufferGeometry,
  material: Material,
  object: Object3D,
  group: GeometryGroup | null,
) => void;

/** Returns a renderer's function that draws one object with one material, for use inside its `render`. */
export function directDraw(webgl: WebGLRenderer): DirectDraw {
  return webgl.renderBufferDirect as unknown as DirectDraw;
}
