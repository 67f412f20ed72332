import { t } from '@farol/editing';
import { readPixels } from '@farol/renderer/read-pixels';
import {
  LinearSRGBColorSpace,
  Mesh,
  OrthographicCamera,
  PlaneGeometry,
  RawShaderMaterial,
  Scene,
  SRGBColorSpace,
  type Texture,
  type WebGLRenderer,
  WebGLRenderTarget,
  GLSL3,
} from 'three';
import fragmentShader from './readTexels.frag.glsl?raw';
import vertexShader from './readTexels.vert.glsl?raw';

/**
 * Reads back any texture that the GPU can sample (compressed, floats): RGBA bytes, row of v = 0 first, in the texture's
 * colour space, clamped to 1.
 * @throws Error when the context is lost meanwhile
 */
export async function readTexels(
  webgl: WebGLRenderer,
  texture: Texture,
  width: number,
  height: number,
): Promise<Uint8ClampedArray<ArrayBuffer>> {
  const isSRGB = texture.colorSpace === SRGBColorSpace;
  const material = new RawShaderMaterial({
    glslVersion: GLSL3,
    uniforms: { source: { value: texture }, encode: { value: isSRGB } },
    vertexShader,
    fragmentShader,
    depthTest: false,
    depthWrite: false,
  });
  const plane = new Mesh(new PlaneGeometry(2, 2), material);
  plane.frustumCulled = false;
  const scene = new Scene();
  scene.add(plane);
  const target = new WebGLRenderTarget(width, height, { colorSpace: LinearSRGBColorSpace, depthBuffer: false });
  const previousTarget = webgl.getRenderTarget();
  try {
    webgl.setRenderTarget(target);
    webgl.render(scene, new OrthographicCamera());
    webgl.setRenderTarget(previousTarget);
    const data = new Uint8ClampedArray(width * height * 4);
    if (!(await readPixels(webgl, target, 0, 0, width, height, data))) {
      throw new Error(t('the graphics device was lost: export again when the picture is back.'));
    }
    return data;
  } finally {
    webgl.setRenderTarget(previousTarget);
    target.dispose();
    material.dispose();
    plane.geometry.dispose();
  }
}
