import {
  AdditiveBlending,
  BackSide,
  type Blending,
  Color,
  CustomBlending,
  DataTexture,
  type IUniform,
  Matrix3,
  Matrix4,
  MultiplyBlending,
  NormalBlending,
  OneFactor,
  OneMinusSrcAlphaFactor,
  SrcAlphaFactor,
  SrcColorFactor,
  SubtractiveBlending,
  type Texture,
  Vector2,
  Vector4,
  ZeroFactor,
} from 'three';
import { lacksFloatTargets } from '../../gpu/checkDevice';
import type { FarolEffect } from '../../frame/FarolEffect';
import type { Frame } from '../../frame/Frame';
import type { GBuffer } from '../../gbuffer/GBuffer';
import { storedKind } from '../../passes/gbuffer/gbufferUniforms';
import { PassMaterial } from '../../gpu/PassMaterial';
import { setUnprojectUniforms, unprojectUniforms } from '../../gpu/unprojectUniforms';
import { addMicroShaders } from '../../microshaders/addMicroShaders';
import type { Decal } from './Decal';
import decalAccumulation from './decalAccumulation.glsl?raw';
import decalBox from './decalBox.glsl?raw';
import { DecalFramebuffers } from './DecalFramebuffers';
import decalGBuffer from './decalGBuffer.glsl?raw';
import decalSurface from './decalSurface.glsl?raw';
import { SurfaceCopies } from './SurfaceCopies';

/** Normal scale by which the shader recognises that there is no normal map. */
const NO_NORMAL_MAP = 1e9;
const BLENDINGS: readonly Blending[] = [AdditiveBlending, SubtractiveBlending, MultiplyBlending];
const colour = new Color();

/**
 * Draws the scene's decals (objects of class `Decal`) on the surfaces in their boxes, into the G-buffer, before lighting: all
 * lights shade them with the surface, and a decal's cost depends on its box's pixels, not on the number of lights. Works with
 * `deferred`, `tiled-deferred` and `clustered-deferred`, on opaque surfaces that the G-buffer holds. Other techniques have no
 * G-buffer: decals are then invisible, with a warning; `Decal.toMesh` makes meshes for them. Blendings other than NormalBlending
 * act on the surface's colour before lighting. Indirect light is the surface's own, scaled by the ratio of colours, so a decal
 * on a fully black surface gets none.
 * @see Persson 2011, Volume Decals (GPU Pro 2)
 */
export class Decals implements FarolEffect {
  readonly name = 'decals';
  readonly after = ['gbuffer'] as const;
  readonly needsSurfaces = true;
  readonly lacks = lacksFloatTargets;
  private reached = false;
  private warned = false;
  private readonly framebuffers = new DecalFramebuffers();
  private readonly copies = new SurfaceCopies();
  private readonly white = pixel(255, 255, 255);
  private readonly uniforms = {
    ...unprojectUniforms(),
    farol_frameSize: { value: new Vector2() },
    farol_surfaceDepth: { value: null } as IUniform<Texture | null>,
    farol_surfaceNormal: { value: null } as IUniform<Texture | null>,
    farol_surfaceStored: { value: 0 },
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
    farol_decalBlending: { value: NormalBlending as Blending },
  };
  private materials: readonly [PassMaterial, PassMaterial] | null = null;

  get bytes(): number {
    return this.copies.bytes;
  }

  begin(): void {
    this.reached = false;
  }

  render(frame: Frame): void {
    this.reached = true;
    let drawn = 0;
    for (const item of frame.queue.opaque) {
      const decal = item.object as Decal;
      if (decal.isDecal !== true) continue;
      item.drawn = true;
      if (drawn === 0) this.prepare(frame, frame.resources.get('gbuffer'));
      drawn++;
      this.draw(frame, decal);
    }
    if (drawn === 0) return;
    frame.resources.put('decals', drawn);
    frame.bindTarget();
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
    this.copies.dispose();
    this.white.dispose();
    for (const material of this.materials ?? []) material.dispose();
    this.materials = null;
  }

  /** Copies the surface attachments that are read while written, and sets the uniforms to the copies. */
  private prepare(frame: Frame, gbuffer: GBuffer): void {
    const { copies, uniforms } = this;
    copies.copy(frame, gbuffer);
    this.materials ??= this.makeMaterials(frame);
    this.framebuffers.follow(frame, gbuffer);
    frame.bind(gbuffer.target); // binds the G-buffer again, which also sets its viewport
    setUnprojectUniforms(uniforms, frame.camera, frame.webgl);
    uniforms.farol_frameSize.value.set(frame.width, frame.height);
    uniforms.farol_surfaceDepth.value = gbuffer.depth;
    uniforms.farol_surfaceNormal.value = copies.normal;
    uniforms.farol_surfaceStored.value = gbuffer.storesDistance ? storedKind(frame.camera) : 0;
    uniforms.farol_surfaceAlbedo.value = copies.albedo;
    uniforms.farol_surfaceMaterial.value = gbuffer.material;
    uniforms.farol_environment.value = Boolean(frame.scene.environment);
  }

  private draw(frame: Frame, decal: Decal): void {
    const { uniforms } = this;
    const { surface } = decal;
    const { blending, map, normalMap, opacity, roughness, metalness, normalScale } = surface;
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
    uniforms.farol_decalBlending.value = BLENDINGS.includes(blending) ? blending : NormalBlending;
    this.copies.follow(frame, decal.modelViewMatrix);
    const [light, surfaces] = this.materials!;
    this.framebuffers.bindLight(frame);
    light.uniformsNeedUpdate = true;
    frame.drawMesh(decal, light);
    this.framebuffers.bindSurface(frame);
    surfaces.uniformsNeedUpdate = true;
    frame.drawMesh(decal, surfaces);
  }

  private makeMaterials(frame: Frame): readonly [PassMaterial, PassMaterial] {
    addMicroShaders(frame.microshaders, 'Decals', { decalBox, decalSurface, decalAccumulation, decalGBuffer });
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
    // the alpha channels hold other data, and are not blended
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
