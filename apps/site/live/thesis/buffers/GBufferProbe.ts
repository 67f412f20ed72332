import {
  type FarolEffect,
  type Frame,
  FullscreenPass,
  gbufferUniforms,
  setGBufferUniforms,
} from '@farol/renderer/authoring';
import { readPixels } from '@farol/renderer/read-pixels';
import { FloatType, Vector2, type WebGLRenderer, type WebGLRenderTarget } from 'three';
import gbufferProbe from './gbufferProbe.glsl?raw';

/** Texels of the probe: depth, then the four attachments. */
const ROWS = 5;

/** Reads one pixel of the G-buffer: of each attachment, as it is stored. */
export class GBufferProbe implements FarolEffect {
  readonly name = 'g-buffer probe';
  /** Place of the pixel, in shares of the picture's width and height, from the left and below. */
  readonly place = new Vector2(0.4, 0.6);
  private readonly pass = new FullscreenPass({
    program: 'g-buffer probe',
    fragment: 'gbufferProbe',
    microShaders: { gbufferProbe },
    uniforms: { ...gbufferUniforms(), thesis_pixel: { value: [0, 0] } },
    target: { type: FloatType },
  });
  private target: WebGLRenderTarget | null = null;
  private readonly values = new Float32Array(4 * ROWS);
  private isReading = false;

  get bytes(): number {
    return this.pass.bytes;
  }

  end(frame: Frame): void {
    const gbuffer = frame.resources.find('gbuffer');
    if (gbuffer === undefined) return;
    const { uniforms } = this.pass;
    setGBufferUniforms(uniforms, gbuffer, frame);
    uniforms.thesis_pixel.value[0] = Math.floor(this.place.x * frame.width);
    uniforms.thesis_pixel.value[1] = Math.floor(this.place.y * frame.height);
    this.target = this.pass.drawToOwn(frame, ROWS, 1);
  }

  /**
   * Reads the pixel of the last frame, without holding up the page.
   * @param told - called with four values for each of depth, accumulation, normal, material and albedo
   */
  async read(webgl: WebGLRenderer, told: (values: Float32Array) => void): Promise<void> {
    if (this.isReading || this.target === null) return;
    this.isReading = true;
    const isThere = await readPixels(webgl, this.target, 0, 0, ROWS, 1, this.values);
    this.isReading = false;
    if (isThere) told(this.values);
  }

  dispose(): void {
    this.pass.dispose();
    this.target = null;
  }
}
