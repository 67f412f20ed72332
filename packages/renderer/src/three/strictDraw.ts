import { type DepthModes, LessDepth, LessEqualDepth, type WebGLRenderer } from 'three';
import { directDraw, type DirectDraw } from './directDraw';

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
