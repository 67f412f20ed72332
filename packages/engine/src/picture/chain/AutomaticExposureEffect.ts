// an optional peer dependency: when it is absent, bundlers fail on named imports, but not on a namespace
import * as postprocessing from 'postprocessing';
import {
  type Camera,
  FloatType,
  HalfFloatType,
  LinearFilter,
  LinearMipmapNearestFilter,
  NearestFilter,
  NoBlending,
  ShaderMaterial,
  Uniform,
  Vector2,
  WebGLRenderTarget,
  type WebGLRenderer,
} from 'three';
import type { Scene } from '../../core/Scene';
import type { AutomaticExposure } from '../PictureLook';

/** Width and height of the texture that is measured, and its smallest mipmap level. */
const SIZE = 256;
const LAST_LEVEL = 8;

const screenCode = `varying vec2 vUv;
void main() {
  vUv = position.xy * 0.5 + 0.5;
  gl_Position = vec4(position.xy, 1.0, 1.0);
}`;
/** Shader that writes the base-2 logarithm of the picture's luminance (linear sRGB). */
const measureCode = `uniform highp sampler2D picture; varying vec2 vUv;
void main() {
  vec3 light = min(texture2D(picture, vUv).rgb, vec3(65504.0));
  gl_FragColor = vec4(log2(max(dot(light, vec3(0.2126, 0.7152, 0.0722)), 1e-6)));
}`;
const adaptCode = `uniform highp sampler2D measured, before; uniform float share;
void main() {
  float now = textureLod(measured, vec2(0.5), ${LAST_LEVEL}.0).r;
  gl_FragColor = vec4(share < 1.0 ? mix(texture2D(before, vec2(0.5)).r, now, share) : now);
}`;
/** Shader that exposes by the luminance L: EV = log2(8 L), factor 1 / (1.2 × 2^EV), see `photometry/exposure.ts`. */
const exposeCode = `uniform highp sampler2D adapted; uniform vec2 limits;
void mainImage(const in vec4 inputColor, const in vec2 uv, out vec4 outputColor) {
  float value = clamp(texture2D(adapted, vec2(0.5)).r + 3.0, limits.x, limits.y);
  outputColor = vec4(inputColor.rgb * (exp2(-value) / 1.2), inputColor.a);
}`;

/** Draws a material over a whole target. */
class ScreenPass extends postprocessing.Pass {
  constructor(fragmentShader: string, uniforms: Record<string, Uniform>) {
    super();
    this.needsSwap = false;
    this.fullscreenMaterial = new ShaderMaterial({
      vertexShader: screenCode,
      fragmentShader,
      uniforms,
      ...{ blending: NoBlending, depthTest: false, depthWrite: false, toneMapped: false },
    });
  }

  override render(webgl: WebGLRenderer, _from: WebGLRenderTarget | null, to: WebGLRenderTarget | null): void {
    webgl.setRenderTarget(to);
    webgl.render(this.scene, this.camera);
  }
}

const makePoint = (): WebGLRenderTarget =>
  new WebGLRenderTarget(1, 1, {
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });

/**
 * Exposes the picture by its geometric mean luminance, within limits, entirely on the GPU. While the scene plays,
 * exposure adapts over scene time; otherwise at once.
 */
export class AutomaticExposureEffect extends postprocessing.Effect {
  private readonly limits = new Vector2();
  private readonly picture = new Uniform<unknown>(null);
  private readonly previous = new Uniform<unknown>(null);
  private readonly adapted = new Uniform<unknown>(null);
  private readonly share = new Uniform(1);
  private readonly logarithms: WebGLRenderTarget;
  private points = [makePoint(), makePoint()] as const;
  private readonly measure: ScreenPass;
  private readonly adapt: ScreenPass;
  private camera: Camera | null = null;
  private time = 0;

  constructor() {
    super('AutomaticExposureEffect', exposeCode, { blendFunction: postprocessing.BlendFunction.SRC });
    this.uniforms.set('adapted', this.adapted);
    this.uniforms.set('limits', new Uniform(this.limits));
    this.logarithms = new WebGLRenderTarget(SIZE, SIZE, {
      type: HalfFloatType,
      minFilter: LinearMipmapNearestFilter,
      magFilter: LinearFilter,
      generateMipmaps: true,
      depthBuffer: false,
    });
    this.measure = new ScreenPass(measureCode, { picture: this.picture });
    const measured = new Uniform(this.logarithms.texture);
    this.adapt = new ScreenPass(adaptCode, { measured, before: this.previous, share: this.share });
  }

  /** Sets the limits, and the share of the adaptation in the next frame. */
  follow({ minEV, maxEV, time }: AutomaticExposure, scene: Scene, camera: Camera): void {
    this.limits.set(minEV, Math.max(minEV, maxEV));
    const passed = scene.time - this.time;
    const isAtOnce = camera !== this.camera || time === 0 || passed < 0 || !scene.isSimulated;
    this.share.value = isAtOnce ? 1 : 1 - Math.exp(-passed / time);
    this.camera = camera;
    this.time = scene.time;
  }

  override update(webgl: WebGLRenderer, from: WebGLRenderTarget): void {
    const [before, next] = this.points;
    this.picture.value = from.texture;
    this.previous.value = before.texture;
    this.measure.render(webgl, null, this.logarithms);
    this.adapt.render(webgl, null, next);
    this.adapted.value = next.texture;
    this.points = [next, before];
  }

  override dispose(): void {
    super.dispose();
    this.logarithms.dispose();
    this.points.forEach((point) => point.dispose());
    this.measure.dispose();
    this.adapt.dispose();
  }
}
