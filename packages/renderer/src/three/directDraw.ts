import {
  type BufferGeometry,
  type Camera,
  type DepthModes,
  LessDepth,
  LessEqualDepth,
  type Material,
  type Object3D,
  type Scene,
  type WebGLRenderer,
} from 'three';
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

/** Returns a function that draws as `directDraw` does, but with LessDepth in place of LessEqualDepth. */
export function strictDraw(webgl: WebGLRenderer): DirectDraw {
  const draw = directDraw(webgl);
  let { depth } = webgl.state.buffers;
  let { setFunc } = depth;
  const setStrictly = (func: DepthModes): void => setFunc.call(depth, func === LessEqualDepth ? LessDepth : func);
  return (camera, scene, geometry, material, object, group) => {
    depth = webgl.state.buffers.depth;
    setFunc = depth.setFunc;
    depth.setFunc = setStrictly;
    try {
      draw(camera, scene, geometry, material, object, group);
    } finally {
      depth.setFunc = setFunc;
    }
  };
}
