import {
  BackSide,
  Color,
  CustomBlending,
  DataTexture,
  HalfFloatType,
  type IUniform,
  Matrix3,
  Matrix4,
  NearestFilter,
  OneFactor,
  OneMinusSrcAlphaFactor,
  RGFormat,
  SrcAlphaFactor,
  SrcColorFactor,
  type Texture,
  Vector4,
  type WebGLRenderTarget,
  ZeroFactor,
} from 'three';
import type { FarolEffect } from '../../FarolEffect';
import type { Frame } from '../../Frame';
import type { GBuffer } from '../../gbuffer/GBuffer';
import { GBufferPass } from '../../passes/GBufferPass';
import type { Pass } from '../../passes/Pass';
import { PassMaterial } from '../../passes/PassMaterial';
import { setUnprojectUniforms, unprojectUniforms } from '../../passes/unprojectUniforms';
import { addMicroShaders } from '../../microshaders/addMicroShaders';
import { EffectTarget } from '../EffectTarget';
import type { Decal } from './Decal';
import decalAccumulation from './decalAccumulation.glsl?raw';
import decalBox from './decalBox.glsl?raw';
import { DecalFramebuffers } from './DecalFramebuffers';
import decalGBuffer from './decalGBuffer.glsl?raw';
import decalSurface from './decalSurface.glsl?raw';

/** In place of a normal map's scale where there is none. */
const NO_NORMAL_MAP = 1e9;
const NEAREST = { minFilter: NearestFilter, magFilter: NearestFilter } as const;
const colour = new Color();

/**
 * Puts the scene's decals (objects of class `Decal`) on the surfaces in their boxes, in the G-buffer and before any light: so
 * all lights shade them with the surface, and a decal costs the pixels of its box, whatever the number of lights.
 *
 * With `deferred`, `tiled-deferred` and `clustered-deferred`, on opaque surfaces that the G-buffer holds. Other techniques
 * have no surfaces to write to: there decals are not seen, and a warning says so; `Decal.toMesh` gives meshes for those.
 * Indirect light is taken from the surface's own by the ratio of colours, so a surface that is quite black has none to give.
 * @see Persson 2011, Volume Decals (GPU Pro 2)
 */
export class Decals implements FarolEffect {
  readonly name = 'decals';
  readonly after = ['gbuffer'] as const;
  readonly needsSurfaces = true;
  private reached = false;
  private warned = false;
  private readonly framebuffers = new DecalFramebuffers();
  private readonly normals = new EffectTarget({ format: RGFormat, type: HalfFloatType, ...NEAREST }, 4);
  private readonly albedos = new EffectTarget({ ...NEAREST }, 4);
  private readonly white = pixel(255, 255, 255);
  private readonly uniforms = {
    ...unprojectUniforms(),
    farol_surfaceDepth: { value: null } as IUniform<Texture | null>,
    farol_surfaceNormal: { value: null } as IUniform<Texture | null>,
    farol_surfaceAlbedo: { value: null } as IUniform<Texture | null>,
    farol_surfaceMaterial: { value: null } as IUniform<Texture | null>,
    farol_environment: { value: false },
    farol_decalMap: { value: null } as IUniform<Texture | null>,
    farol_decalNormalMap: { value: null } as IUniform<Texture | null>,
    farol_decalInverse: { value: new Matrix4() },
    farol_decalColor: { value: new Vector4() },
    farol_decalMapTransform: { value: new Matrix3() },
    farol_decalNormalMapTransform: { value: new Matrix3() },
    farol_decalValues: { value: new Vector4() },
    farol_decalFacing: { value: 0 },
  };
  private materials: readonly [PassMaterial, PassMaterial] | null = null;

  get bytes(): number {
    return this.normals.bytes + this.albedos.bytes;
  }

  begin(): void {
    this.reached = false;
  }

  render(frame: Frame, pass: Pass): void {
    this.reached = true;
    let first = true;
    for (const item of frame.queue.opaque) {
      const decal = item.object as Decal;
      if (decal.isDecal !== true) continue;
      item.drawn = true;
      if (first) this.prepare(frame, (pass as GBufferPass).gbuffer!);
      first = false;
      this.draw(frame, decal);
    }
    if (!first) frame.bindTarget();
  }

  end(frame: Frame): void {
    if (this.reached || this.warned) return;
    for (const { object } of frame.queue.opaque) this.warned ||= (object as Decal).isDecal === true;
    if (!this.warned) return;
    console.warn(
      "Farol: decals are not drawn, since the technique in use has no G-buffer; use 'deferred', 'tiled-deferred' or 'clustered-deferred', or put decal.toMesh(mesh) into the scene.",
    );
  }

  dispose(): void {
    this.framebuffers.dispose();
    this.normals.dispose();
    this.albedos.dispose();
    this.white.dispose();
    for (const material of this.materials ?? []) material.dispose();
    this.materials = null;
  }

  /** Copies what is read of the surfaces while it is written, and points the uniforms at it. */
  private prepare(frame: Frame, gbuffer: GBuffer): void {
    const { uniforms } = this;
    const { width, height } = gbuffer.target;
    const normals = this.normals.of(width, height);
    const albedos = this.albedos.of(width, height);
    copyAttachment(frame, gbuffer.target, 1, normals);
    copyAttachment(frame, gbuffer.target, 2, albedos);
    this.materials ??= this.makeMaterials(frame);
    this.framebuffers.follow(frame, gbuffer);
    frame.bind(gbuffer.target); // its viewport
    setUnprojectUniforms(uniforms, frame.camera, frame.webgl);
    uniforms.farol_surfaceDepth.value = gbuffer.depth;
    uniforms.farol_surfaceNormal.value = normals.texture;
    uniforms.farol_surfaceAlbedo.value = albedos.texture;
    uniforms.farol_surfaceMaterial.value = gbuffer.material;
    uniforms.farol_environment.value = Boolean(frame.scene.environment);
  }

  private draw(frame: Frame, decal: Decal): void {
    const { uniforms } = this;
    const { surface } = decal;
    const { map, normalMap, opacity, roughness, metalness, normalScale } = surface;
    decal.modelViewMatrix.multiplyMatrices(frame.camera.matrixWorldInverse, decal.matrixWorld);
    uniforms.farol_decalInverse.value.copy(decal.modelViewMatrix).invert();
    colour.copy(surface.color);
    uniforms.farol_decalColor.value.set(colour.r, colour.g, colour.b, opacity);
    uniforms.farol_decalMap.value = map ?? this.white;
    uniforms.farol_decalNormalMap.value = normalMap ?? this.white;
    setTransform(uniforms.farol_decalMapTransform.value, map);
    setTransform(uniforms.farol_decalNormalMapTransform.value, normalMap);
    const scale = normalMap === null ? NO_NORMAL_MAP : normalScale.x;
    uniforms.farol_decalValues.value.set(roughness, metalness, scale, normalScale.y);
    uniforms.farol_decalFacing.value = Math.cos(decal.maximumAngle);
    const [light, surfaces] = this.materials!;
    this.framebuffers.bindLight(frame);
    light.uniformsNeedUpdate = true;
    frame.drawMesh(decal, light);
    this.framebuffers.bindSurface(frame);
    surfaces.uniformsNeedUpdate = true;
    frame.drawMesh(decal, surfaces);
  }

  private makeMaterials(frame: Frame): readonly [PassMaterial, PassMaterial] {
    addMicroShaders(frame.microshaders, { decalBox, decalSurface, decalAccumulation, decalGBuffer });
    const material = (chunk: string) =>
      new PassMaterial(frame.microshaders, {
        name: `Farol ${chunk}`,
        vertex: ['decalBox'],
        fragment: [chunk],
        uniforms: this.uniforms,
        side: BackSide,
        blending: CustomBlending,
      });
    const light = material('decalAccumulation');
    const surfaces = material('decalGBuffer');
    light.blendSrc = ZeroFactor;
    light.blendDst = SrcColorFactor;
    surfaces.blendSrc = SrcAlphaFactor;
    surfaces.blendDst = OneMinusSrcAlphaFactor;
    // alpha holds other things: it stays
    for (const one of [light, surfaces]) {
      one.blendSrcAlpha = ZeroFactor;
      one.blendDstAlpha = OneFactor;
    }
    return [light, surfaces];
  }
}

function pixel(r: number, g: number, b: number): DataTexture {
  const texture = new DataTexture(new Uint8Array([r, g, b, 255]), 1, 1);
  texture.needsUpdate = true;
  return texture;
}

function setTransform(matrix: Matrix3, texture: Texture | null): void {
  if (texture === null) {
    matrix.identity();
    return;
  }
  if (texture.matrixAutoUpdate) texture.updateMatrix();
  matrix.copy(texture.matrix);
}

function copyAttachment(frame: Frame, from: WebGLRenderTarget, attachment: number, to: WebGLRenderTarget): void {
  const { gl } = frame;
  const { properties, state } = frame.webgl;
  const framebuffer = (target: WebGLRenderTarget) =>
    (properties.get(target) as { __webglFramebuffer: WebGLFramebuffer }).__webglFramebuffer;
  frame.bind(to); // made by then
  state.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer(from));
  gl.readBuffer(gl.COLOR_ATTACHMENT0 + attachment);
  gl.blitFramebuffer(0, 0, from.width, from.height, 0, 0, to.width, to.height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
  gl.readBuffer(gl.COLOR_ATTACHMENT0);
  state.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
}
