import { readPixels } from '@farol/renderer/read-pixels';
import {
  FloatType,
  GLSL3,
  Mesh,
  NearestFilter,
  OrthographicCamera,
  PlaneGeometry,
  RawShaderMaterial,
  Scene,
  type Texture,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { whenLost } from '../whenLost';
import differenceShader from './difference.frag.glsl?raw';
import sumShader from './differenceSum.frag.glsl?raw';
import vertexShader from './whole.vert.glsl?raw';

/** Difference between two images, measured on sRGB-encoded values from 0 to 1. */
export interface DifferenceFigures {
  /** Peak signal-to-noise ratio (dB); infinite for identical images. */
  readonly psnr: number;
  /** Largest difference of a colour channel, in steps of 1/255. */
  readonly largest: number;
  /** Share of the pixels with a channel off by more than 2/255. */
  readonly differing: number;
}

/** Side of the blocks summed on the GPU (pixels); must equal the shader's. */
const BLOCK = 16;

/** Shows and measures the difference between two linear images. */
export class PictureDifference {
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly quad: Mesh<PlaneGeometry, RawShaderMaterial>;
  private readonly sums = new WebGLRenderTarget(1, 1, {
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
  private readonly uniforms = {
    a: { value: null as Texture | null },
    b: { value: null as Texture | null },
    gain: { value: 8 },
  };
  private readonly shown = this.material('Editor difference', differenceShader);
  private readonly summed = this.material('Editor difference sums', sumShader);
  private readonly endLost: () => void;

  constructor(private readonly webgl: WebGLRenderer) {
    this.quad = new Mesh(new PlaneGeometry(2, 2), this.shown);
    this.quad.frustumCulled = false;
    this.scene.add(this.quad);
    this.endLost = whenLost(webgl, () => this.free());
  }

  /** Draws the difference to the bound target. @param gain - factor applied to the difference */
  show(a: Texture, b: Texture, gain: number): void {
    this.uniforms.gain.value = gain;
    this.draw(this.shown, a, b);
  }

  /**
   * Measures the difference between two images, asynchronously.
   * @param width - width of both images (pixels) @param height - height of both images (pixels)
   * @returns null when the context was lost meanwhile
   */
  async measure(a: Texture, b: Texture, width: number, height: number): Promise<DifferenceFigures | null> {
    const { webgl, sums } = this;
    const [across, down] = [Math.ceil(width / BLOCK), Math.ceil(height / BLOCK)];
    sums.setSize(across, down);
    const previousTarget = webgl.getRenderTarget();
    webgl.setRenderTarget(sums);
    this.draw(this.summed, a, b);
    webgl.setRenderTarget(previousTarget);
    const blocks = new Float32Array(across * down * 4);
    if (!(await readPixels(webgl, sums, 0, 0, across, down, blocks))) return null;
    let [squares, largest, differing] = [0, 0, 0];
    for (let i = 0; i < blocks.length; i += 4) {
      squares += blocks[i];
      largest = Math.max(largest, blocks[i + 1]);
      differing += blocks[i + 2];
    }
    const pixels = width * height;
    return { psnr: -10 * Math.log10(squares / (pixels * 3)), largest: largest * 255, differing: differing / pixels };
  }

  dispose(): void {
    this.endLost();
    this.free();
  }

  private free(): void {
    this.sums.dispose();
    this.shown.dispose();
    this.summed.dispose();
    this.quad.geometry.dispose();
  }

  private draw(material: RawShaderMaterial, a: Texture, b: Texture): void {
    const { webgl, uniforms } = this;
    uniforms.a.value = a;
    uniforms.b.value = b;
    this.quad.material = material;
    const { autoClear } = webgl;
    webgl.autoClear = true;
    webgl.render(this.scene, this.camera);
    webgl.autoClear = autoClear;
  }

  private material(name: string, fragmentShader: string): RawShaderMaterial {
    return new RawShaderMaterial({
      name,
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: this.uniforms,
      depthTest: false,
      depthWrite: false,
    });
  }
}
