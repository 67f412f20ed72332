import { HalfFloatType, LinearFilter, type Data3DTexture, WebGL3DRenderTarget, type WebGLRenderTarget } from 'three';
import type { Frame } from '../../frame/Frame';
import { textureHandle } from '../../three/handles';
import type { Froxels } from './froxels';
import { bindFramebuffer } from '../../three/state';

/** 3D texture with a texel of half floats for each froxel; one draw writes several slices. */
export class FroxelTexture {
  private target: WebGL3DRenderTarget | null = null;
  private framebuffers: WebGLFramebuffer[] = [];
  private attached: WebGLTexture | null = null;
  private gl: WebGL2RenderingContext | null = null;

  get texture(): Data3DTexture | null {
    return (this.target?.texture ?? null) as Data3DTexture | null;
  }

  get bytes(): number {
    const { width = 0, height = 0, depth = 0 } = this.target ?? {};
    return width * height * depth * 8;
  }

  /** Creates the texture if there is none of this size. @param size - froxels across, up and in depth */
  fit([width, height, depth]: Froxels): void {
    const { target } = this;
    if (target !== null && target.width === width && target.height === height && target.depth === depth) return;
    this.dispose();
    this.target = new WebGL3DRenderTarget(width, height, depth, {
      type: HalfFloatType,
      minFilter: LinearFilter,
      magFilter: LinearFilter,
      depthBuffer: false,
    });
  }

  /** Binds slices for the draws that follow. @param draw - index of the draw, each of `layers` slices */
  bind(frame: Frame, draw: number, layers: number): void {
    const { gl, webgl } = frame;
    frame.bind(this.target as unknown as WebGLRenderTarget); // sets the viewport, and allocates the texture
    const handle = textureHandle(webgl, this.target!.texture)!;
    if (handle !== this.attached) this.attach(frame, handle, layers);
    bindFramebuffer(webgl, gl.FRAMEBUFFER, this.framebuffers[draw]);
  }

  dispose(): void {
    this.target?.dispose();
    this.target = null;
    this.detach();
  }

  private attach({ gl, webgl }: Frame, handle: WebGLTexture, layers: number): void {
    this.detach();
    this.gl = gl;
    this.attached = handle;
    const buffers = Array.from({ length: layers }, (_, i) => gl.COLOR_ATTACHMENT0 + i);
    for (let first = 0; first < this.target!.depth; first += layers) {
      const framebuffer = gl.createFramebuffer();
      bindFramebuffer(webgl, gl.FRAMEBUFFER, framebuffer);
      buffers.forEach((buffer, i) => gl.framebufferTextureLayer(gl.FRAMEBUFFER, buffer, handle, 0, first + i));
      gl.drawBuffers(buffers);
      this.framebuffers.push(framebuffer);
    }
  }

  private detach(): void {
    for (const framebuffer of this.framebuffers) {
      // framebuffers of a lost context are gone
      if (this.gl?.isFramebuffer(framebuffer)) this.gl.deleteFramebuffer(framebuffer);
    }
    this.framebuffers = [];
    this.attached = null;
  }
}
