import type { Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import { gbufferLayout } from '../../gbuffer/gbufferLayout';
import type { GBuffer } from '../../gbuffer/GBuffer';
import { textureHandle } from '../../three/handles';
import { bindFramebuffer } from '../../three/state';

/** Framebuffers with a G-buffer's attachments but not its depth, so that shaders may read depth while drawing to them. */
export class DecalFramebuffers {
  private attached: WebGLTexture[] = [];
  private framebuffers: WebGLFramebuffer[] = [];
  private gl: WebGL2RenderingContext | null = null;

  /** Updates the framebuffers to the frame's G-buffer. */
  follow(frame: Frame, gbuffer: GBuffer): void {
    const { gl, webgl } = frame;
    const handle = (texture: Texture) => textureHandle(webgl, texture)!;
    // further attachments, added to the G-buffer by effects, hold light
    const light = [gbuffer.emissive, ...gbuffer.target.textures.slice(gbufferLayout.length)];
    const groups = [light.map(handle), [gbuffer.albedo, gbuffer.normal, gbuffer.material].map(handle)];
    const all = groups.flat();
    if (all.length === this.attached.length && all.every((texture, i) => texture === this.attached[i])) return;
    this.dispose();
    this.gl = gl;
    this.attached = all;
    this.framebuffers = groups.map((textures) => {
      const framebuffer = gl.createFramebuffer();
      bindFramebuffer(webgl, gl.FRAMEBUFFER, framebuffer);
      textures.forEach((texture, i) =>
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0),
      );
      gl.drawBuffers(textures.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
      return framebuffer;
    });
  }

  /** Binds accumulation (and indirect light) for the draws that follow. */
  bindLight(frame: Frame): void {
    bindFramebuffer(frame.webgl, frame.gl.FRAMEBUFFER, this.framebuffers[0]);
  }

  /** Binds albedo, normal and material for the draws that follow. */
  bindSurface(frame: Frame): void {
    bindFramebuffer(frame.webgl, frame.gl.FRAMEBUFFER, this.framebuffers[1]);
  }

  dispose(): void {
    for (const framebuffer of this.framebuffers) {
      // framebuffers of a lost context are gone
      if (this.gl?.isFramebuffer(framebuffer)) this.gl.deleteFramebuffer(framebuffer);
    }
    this.framebuffers = [];
    this.attached = [];
  }
}
