import { HalfFloatType, type Matrix4, RGFormat, type Texture, Vector4, type WebGLRenderTarget } from 'three';
import type { Frame } from '../../frame/Frame';
import type { GBuffer } from '../../gbuffer/GBuffer';
import { PassTarget } from '../../gpu/PassTarget';
import { boxRectangle } from './boxRectangle';
import { framebufferHandle } from '../../three/handles';
import { bindFramebuffer } from '../../three/state';

/** Copies of a G-buffer's normals and albedo, which are read while the G-buffer itself is written. */
export class SurfaceCopies {
  private readonly normalTarget = new PassTarget({ format: RGFormat, type: HalfFloatType });
  /** Copy of the surfaces' distances, for a G-buffer that stores them. */
  private readonly distanceTarget = new PassTarget({ type: HalfFloatType });
  private readonly albedoTarget = new PassTarget();
  private gbuffer!: WebGLRenderTarget;
  private normals!: WebGLRenderTarget;
  private albedos!: WebGLRenderTarget;
  /** Rectangles of pixels written since `copy`: x, y, width, height of each decal's box. */
  private readonly written: Vector4[] = [];
  private boxes = 0;

  get bytes(): number {
    return this.normalTarget.bytes + this.distanceTarget.bytes + this.albedoTarget.bytes;
  }

  /** Normals of the surfaces below all decals, and distances where they are stored. */
  get normal(): Texture {
    return this.normals.texture;
  }

  /** Albedo below the next decal, earlier decals included. */
  get albedo(): Texture {
    return this.albedos.texture;
  }

  /** Copies normals, albedo and distances of a G-buffer. Leaves another target bound. */
  copy(frame: Frame, { target, storesDistance }: GBuffer): void {
    const { z: width, w: height } = target.viewport;
    this.gbuffer = target;
    this.normals = (storesDistance ? this.distanceTarget : this.normalTarget).of(width, height);
    this.albedos = this.albedoTarget.of(width, height);
    this.boxes = 0;
    const whole = this.rectangle(0).set(0, 0, width, height);
    frame.bind(this.normals); // allocates the target's textures, which the copy needs
    copyAttachment(frame, target, 1, this.normals, whole);
    frame.bind(this.albedos);
    copyAttachment(frame, target, 2, this.albedos, whole);
  }

  /**
   * Updates the albedo where the next decal may overlap earlier ones. May leave another framebuffer bound.
   * @param modelView - transform from the decal's box to view space (m)
   */
  follow(frame: Frame, modelView: Matrix4): void {
    const rectangle = this.rectangle(this.boxes);
    boxRectangle(modelView, frame.camera.projectionMatrix, frame, rectangle);
    for (let i = 0; i < this.boxes; i++) {
      if (!overlap(rectangle, this.written[i])) continue;
      copyAttachment(frame, this.gbuffer, 2, this.albedos, rectangle);
      break;
    }
    this.boxes++;
  }

  dispose(): void {
    this.normalTarget.dispose();
    this.distanceTarget.dispose();
    this.albedoTarget.dispose();
  }

  private rectangle(index: number): Vector4 {
    return (this.written[index] ??= new Vector4());
  }
}

function overlap(a: Vector4, b: Vector4): boolean {
  return a.x < b.x + b.z && b.x < a.x + a.z && a.y < b.y + b.w && b.y < a.y + a.w;
}

function copyAttachment(
  frame: Frame,
  from: WebGLRenderTarget,
  attachment: number,
  to: WebGLRenderTarget,
  { x, y, z, w }: Vector4,
): void {
  if (z === 0 || w === 0) return;
  const { gl, webgl } = frame;
  bindFramebuffer(webgl, gl.DRAW_FRAMEBUFFER, framebufferHandle(webgl, to)!);
  bindFramebuffer(webgl, gl.READ_FRAMEBUFFER, framebufferHandle(webgl, from)!);
  gl.readBuffer(gl.COLOR_ATTACHMENT0 + attachment);
  gl.blitFramebuffer(x, y, x + z, y + w, x, y, x + z, y + w, gl.COLOR_BUFFER_BIT, gl.NEAREST);
  gl.readBuffer(gl.COLOR_ATTACHMENT0);
  bindFramebuffer(webgl, gl.READ_FRAMEBUFFER, null);
}
