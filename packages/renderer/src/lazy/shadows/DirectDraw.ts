import type { BufferGeometry, Camera, Material, Object3D } from 'three';
import type { GeometryGroup } from '../../frame/RenderItem';

/** three's `renderBufferDirect`, which draws without a scene and without groups too. */
export type DirectDraw = (
  camera: Camera,
  scene: null,
  geometry: BufferGeometry,
  material: Material,
  object: Object3D,
  group: GeometryGroup | null,
) => void;
