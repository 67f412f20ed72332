import {
  DataTexture,
  FloatType,
  HalfFloatType,
  type InstancedBufferGeometry,
  Matrix4,
  NearestFilter,
  type PerspectiveCamera,
  type Texture,
  Vector3,
  type WebGLRenderTarget,
} from 'three';
import type { Frame } from '../../frame/Frame';
import type { ReactiveMask } from '../../frame/ReactiveMask';
import type { RenderItem } from '../../frame/RenderItem';
import type { LightTextures } from '../../light-fields/LightTextures';
import { targetBytes } from '../../gpu/targetBytes';
import { storedKind } from '../../passes/gbuffer/gbufferUniforms';
import { setUnprojectUniforms } from '../../gpu/unprojectUniforms';
import type { OutputMaterial } from '../../gpu/PassMaterial';
import { WebGLMultipleRenderTargets } from '../../three/WebGLMultipleRenderTargets';
import { bakeCurves, CURVE_ROWS, CURVE_TEXELS } from './bakeCurves';
import type { ParticleEmitter } from './ParticleEmitter';
import { type ParticleLook, particleMaterial, particleUniforms } from './particleMaterial';
import { ParticleOrder, type particleSortPasses } from './ParticleOrder';
import type { ParticleLightingPass, particleLightsPass, particleStepPass } from './particlePasses';
import type { PendingStep } from './PendingSteps';
import { type ParticleSurroundings, SurroundingLight } from './ParticleSurroundings';
import type { SurfaceDepth } from './SurfaceDepth';
import { surfaceTable, TEXELS_PER_TRIANGLE } from './surfaceTable';

const SHAPES = { point: 0, sphere: 1, cone: 2, box: 3, mesh: 4 } as const;
/** Width of the texture of a mesh shape's triangles (texels). */
const SURFACE_COLUMNS = 1026;
const WORDS = 4_294_967_296;
const float = new Float64Array(1);
const words = new Uint32Array(float.buffer);
const from = new Vector3();
const turn = new Matrix4();
/** Codes of `orientation` in particleVertex.glsl. */
const ORIENTATIONS = { random: 0, emitter: 1, velocity: 2 } as const;
const to = new Vector3();

/** Width (texels) of an about square texture with a texel for each slot. */
const columnsOf = (slots: number): number => 2 ** Math.ceil(Math.log2(slots) / 2);

/** Converts a seed to 32 bits; whole numbers below 2³² are unchanged. */
function seedBits(seed: number): number {
  if (Number.isInteger(seed) && seed >= 0 && seed < WORDS) return seed;
  float[0] = seed;
  return (words[0] ^ words[1]) >>> 0;
}

function makeTarget(slots: number, textures: number, type: typeof FloatType | typeof HalfFloatType) {
  const columns = columnsOf(slots);
  return new WebGLMultipleRenderTargets(columns, Math.ceil(slots / columns), textures, {
    type,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
}

function floatTexture(data: Float32Array<ArrayBuffer>, width: number, height: number): DataTexture {
  const texture = new DataTexture(data, width, height, undefined, FloatType);
  texture.needsUpdate = true;
  return texture;
}

/** Textures of particles on the GPU. */
export interface ParticleTextures {
  /** World position (m) and age (s) of each particle. */
  readonly positions: Texture;
  /** Velocity (m/s) and lifetime (s) of each particle. */
  readonly velocities: Texture;
}

/** GPU state of one emitter: its particles, their light, their curves, and their material. */
export class ParticleState {
  private particles: [WebGLRenderTarget, WebGLRenderTarget] | null = null;
  private slots = 0;
  private light: WebGLRenderTarget | null = null;
  private around: SurroundingLight | null = null;
  private emitted: WebGLRenderTarget | null = null;
  private emittedLights = 0;
  private lightTextures: LightTextures | null = null;
  private order: ParticleOrder | null = null;
  private readonly curves: DataTexture;
  private curvesVersion = -1;
  private surface: DataTexture | null = null;
  private surfaceTriangles = 0;
  private surfaceRestart = -1;
  private readonly uniforms = particleUniforms();
  private material: OutputMaterial | null = null;
  private maskMaterial: OutputMaterial | null = null;
  private parts: ParticleLook | null = null;
  private partsKey = '';

  constructor(private readonly emitter: ParticleEmitter) {
    this.curves = floatTexture(new Float32Array(4 * CURVE_TEXELS * CURVE_ROWS), CURVE_TEXELS, CURVE_ROWS);
  }

  /** Bytes of the emitter's targets and textures on the GPU. */
  get bytes(): number {
    let bytes = this.curves.image.data!.byteLength + (this.surface?.image.data?.byteLength ?? 0);
    bytes += (this.order?.bytes ?? 0) + (this.around?.bytes ?? 0);
    for (const target of [...(this.particles ?? []), this.light, this.emitted])
      if (target !== null) bytes += targetBytes(target);
    return bytes;
  }

  /** Textures of the particles after the last step; null before the first one. */
  get textures(): ParticleTextures | null {
    return this.particles === null ? null : { positions: this.positions, velocities: this.velocities };
  }

  private get positions(): Texture {
    return this.particles![0].textures[0];
  }

  private get velocities(): Texture {
    return this.particles![0].textures[1];
  }

  /** Simulates the emitter's pending steps. Binds targets. @returns whether there were any */
  simulate(frame: Frame, pass: ReturnType<typeof particleStepPass>): boolean {
    const { emitter } = this;
    const { pending } = emitter;
    this.bakeCurves();
    emitter.begin();
    if (this.particles === null || this.slots !== emitter.capacity) {
      // the particles' state was lost with the context: restart
      if (!pending.clears) {
        emitter.restart();
        emitter.begin();
      }
      this.makeParticles();
    }
    if (pending.clears) {
      frame.bind(this.particles![0]);
      frame.clear(2, false);
    }
    const changed = pending.clears || pending.count > 0;
    if (pending.count > 0) {
      this.setStepUniforms(pass);
      let start = pending.start;
      for (let i = 0; i < pending.count; i++) {
        this.step(frame, pass, start, pending.steps[i]);
        start = pending.steps[i].matrix;
      }
    }
    pending.done();
    return changed;
  }

  /** Computes the light on each particle, from a pass's light loop and the surroundings. Binds a target. */
  findLight(frame: Frame, pass: ParticleLightingPass, surroundings: ParticleSurroundings): void {
    const { uniforms } = pass;
    this.around ??= new SurroundingLight();
    this.around.find(frame, surroundings, this.emitter.matrixWorld);
    this.uniforms.farol_surroundings.value = this.around.texture;
    if (this.light?.width !== this.particles![0].width || this.light.height !== this.particles![0].height) {
      this.light?.dispose();
      this.light = makeTarget(this.slots, 3, HalfFloatType);
    }
    uniforms.farol_particlePositions.value = this.positions;
    uniforms.farol_particleVelocities.value = this.velocities;
    uniforms.farol_particleView.value.copy(frame.camera.matrixWorldInverse);
    uniforms.farol_particleProjection.value.copy(frame.camera.projectionMatrix);
    uniforms.farol_listPicture.value.set(frame.viewport.x, frame.viewport.y, frame.width, frame.height);
    uniforms.farol_particlesShadowed.value = this.emitter.receiveShadow;
    pass.drawTo(frame, this.light);
    const [red, green, blue] = this.light.textures;
    this.uniforms.farol_particleRed.value = red;
    this.uniforms.farol_particleGreen.value = green;
    this.uniforms.farol_particleBlue.value = blue;
  }

  /** Writes the lights of the emitter's LightField, which must exist. Binds a target. */
  writeLights(frame: Frame, pass: ReturnType<typeof particleLightsPass>): void {
    const { emitter } = this;
    const { uniforms } = pass;
    const { capacity } = emitter.lights!;
    if (this.emitted === null || this.emittedLights !== capacity) {
      this.emitted?.dispose();
      this.emitted = makeTarget(capacity, 2, FloatType);
      this.emittedLights = capacity;
      this.lightTextures = { sphere: this.emitted.textures[0], emission: this.emitted.textures[1] };
    }
    uniforms.farol_particlePositions.value = this.positions;
    uniforms.farol_particleVelocities.value = this.velocities;
    uniforms.farol_particleCurves.value = this.curves;
    uniforms.farol_lightOf.value[0] = emitter.lightEvery;
    uniforms.farol_lightOf.value[1] = this.slots;
    uniforms.farol_lightOf.value[2] = this.emitted.width;
    uniforms.farol_lightValues.value.set(emitter.lightIntensity, emitter.lightRange);
    pass.drawTo(frame, this.emitted);
    emitter.setLightTextures(this.lightTextures);
  }

  /** Sorts the particles if their order is visible. Binds targets. @returns whether they were sorted */
  sort(frame: Frame, passes: ReturnType<typeof particleSortPasses>): boolean {
    if (this.emitter.blending === 'additive') return false;
    this.order ??= new ParticleOrder(this.slots);
    this.order.sort(frame, passes, this.positions, this.velocities);
    this.uniforms.farol_particleOrder.value = this.order.texture;
    return true;
  }

  /** Sets an item of the queue up to draw the particles. */
  giveTo(item: RenderItem, frame: Frame): void {
    const { emitter, uniforms } = this;
    const { schedule } = emitter.pending;
    const { capacity, size, initialRotation, spin, stretch, brightness, flipBook, render } = emitter;
    const isSorted = emitter.blending !== 'additive';
    // sorted slots include those without a particle
    const count = isSorted ? this.order!.places : schedule.begun - schedule.oldest;
    uniforms.farol_particlePositions.value = this.positions;
    uniforms.farol_particleVelocities.value = this.velocities;
    uniforms.farol_particleCurves.value = this.curves;
    uniforms.farol_particleSeed.value = seedBits(emitter.seed);
    uniforms.farol_particleSlots.value[0] = schedule.oldest % capacity;
    uniforms.farol_particleSlots.value[1] = capacity;
    uniforms.farol_oldestNumber.value = schedule.oldest % WORDS;
    uniforms.farol_sizeAndRotation.value.set(size[0], size[1], initialRotation[0], initialRotation[1]);
    uniforms.farol_spinAndStretch.value.set(spin[0], spin[1], stretch, brightness);
    uniforms.farol_orientation.value = ORIENTATIONS[this.emitter.orientation];
    uniforms.farol_emitterTurn.value.setFromMatrix4(turn.extractRotation(this.emitter.matrixWorld));
    if (flipBook === null) uniforms.farol_flipBook.value.set(1, 1, 1);
    else uniforms.farol_flipBook.value.set(flipBook.columns, flipBook.rows, flipBook.cycles ?? 1);
    uniforms.farol_particleMap.value = emitter.texture;
    item.material = this.materialFor(frame);
    if (render === 'mesh') (emitter.geometry as InstancedBufferGeometry).instanceCount = count;
    else emitter.geometry.setDrawRange(0, 6 * count);
  }

  /** @param surfaces - depth of the opaque surfaces */
  setDepth(frame: Frame, surfaces: SurfaceDepth): void {
    const { uniforms } = this;
    const { near } = frame.camera as PerspectiveCamera;
    setUnprojectUniforms(uniforms, frame.camera, frame.webgl);
    uniforms.farol_particleDepth.value = surfaces.of(frame);
    const { distances, scale } = surfaces;
    uniforms.farol_particleDistances.value = distances;
    uniforms.farol_particleStored.value = distances === null ? 0 : storedKind(frame.camera);
    uniforms.farol_softness.value.set(1 / this.emitter.softness, near, scale.x, scale.y);
  }

  /** Makes three upload the uniforms with the next draw. */
  touch(): void {
    if (this.material !== null) this.material.uniformsNeedUpdate = true;
  }

  /** Draws the particles' coverage into the reactive mask. */
  drawMask(frame: Frame, item: RenderItem, mask: ReactiveMask<Frame>): void {
    this.maskMaterial ??= particleMaterial(frame, { ...this.parts!, reactive: true }, this.uniforms);
    this.maskMaterial.uniformsNeedUpdate = true;
    mask.draw(frame, item, this.maskMaterial);
  }

  dispose(): void {
    for (const target of [...(this.particles ?? []), this.light, this.emitted]) target?.dispose();
    this.particles = this.light = this.emitted = null;
    this.around?.dispose();
    this.around = null;
    this.curves.dispose();
    this.surface?.dispose();
    this.surface = null;
    this.dropMaterials();
    this.partsKey = '';
    this.dropOrder();
  }

  private dropMaterials(): void {
    this.material?.dispose();
    this.maskMaterial?.dispose();
    this.material = this.maskMaterial = null;
  }

  private dropOrder(): void {
    this.order?.dispose();
    this.order = null;
  }

  private makeParticles(): void {
    for (const target of this.particles ?? []) target.dispose();
    this.dropOrder();
    this.slots = this.emitter.capacity;
    this.particles = [makeTarget(this.slots, 2, FloatType), makeTarget(this.slots, 2, FloatType)];
  }

  private bakeCurves(): void {
    const { emitter, curves } = this;
    if (this.curvesVersion === emitter.curvesVersion) return;
    this.curvesVersion = emitter.curvesVersion;
    bakeCurves(emitter, curves.image.data as Float32Array<ArrayBuffer>);
    curves.needsUpdate = true;
  }

  /** Uploads the triangles of a mesh shape after a restart of the emitter. */
  private takeSurface(): void {
    const { emitter } = this;
    if (this.surfaceRestart === emitter.restarts) return;
    this.surfaceRestart = emitter.restarts;
    this.surface?.dispose();
    this.surface = null;
    this.surfaceTriangles = 0;
    const { shape } = emitter;
    if (shape.kind !== 'mesh' || shape.mesh === null) return;
    shape.mesh.updateWorldMatrix(true, false);
    const table = surfaceTable(shape.mesh);
    if (table === null) return;
    const rows = Math.ceil((table.triangles * TEXELS_PER_TRIANGLE) / SURFACE_COLUMNS);
    const data = new Float32Array(SURFACE_COLUMNS * rows * 4);
    data.set(table.data);
    this.surface = floatTexture(data, SURFACE_COLUMNS, rows);
    this.surfaceTriangles = table.triangles;
  }

  /** Sets the uniforms that all steps of a frame share. */
  private setStepUniforms({ uniforms }: ReturnType<typeof particleStepPass>): void {
    const { emitter } = this;
    const { shape, gravity, drag, colliders, life, speed } = emitter;
    this.takeSurface();
    uniforms.farol_particleSeed.value = seedBits(emitter.seed);
    uniforms.farol_emitterShape.value[0] = SHAPES[shape.kind];
    uniforms.farol_emitterShape.value[1] = this.surfaceTriangles;
    uniforms.farol_emitterSurface.value = this.surface ?? this.curves;
    const size = uniforms.farol_emitterSize.value.set(0, 0, 0);
    if (shape.kind === 'sphere') size.set(shape.radius, shape.thickness, 0);
    else if (shape.kind === 'cone') size.set(shape.radius, shape.angle, 0);
    else if (shape.kind === 'box') size.set(shape.size[0], shape.size[1], shape.size[2]);
    uniforms.farol_acceleration.value.set(gravity[0], gravity[1], gravity[2], drag);
    uniforms.farol_noise.value.set(emitter.noiseStrength, emitter.noiseFrequency, 0, 0);
    uniforms.farol_lifeAndSpeed.value.set(life[0], life[1], speed[0], speed[1]);
    uniforms.farol_colliderCount.value = colliders.length;
    for (let i = 0; i < colliders.length; i++) {
      const collider = colliders[i];
      const isSphere = collider.kind === 'sphere';
      const to = uniforms.farol_colliders.value[i];
      if (isSphere) to.set(collider.center[0], collider.center[1], collider.center[2], collider.radius);
      else {
        const [x, y, z] = collider.normal;
        const length = Math.hypot(x, y, z);
        to.set(x / length, y / length, z / length, collider.height);
      }
      uniforms.farol_bounces.value[i].set(collider.bounce, collider.friction, isSphere ? 1 : 0);
    }
  }

  private step(frame: Frame, pass: ReturnType<typeof particleStepPass>, start: Matrix4, step: PendingStep): void {
    const { emitter } = this;
    const { uniforms } = pass;
    const { shape, inheritVelocity, space } = emitter;
    const [now, next] = this.particles!;
    const { seconds, matrix } = step;
    // a mesh without triangles emits nothing
    const begins = shape.kind !== 'mesh' || this.surfaceTriangles > 0;
    uniforms.farol_beginning.value[0] = step.first % this.slots;
    uniforms.farol_beginning.value[1] = begins ? step.bursting : 0;
    uniforms.farol_beginning.value[2] = begins ? step.rated : 0;
    uniforms.farol_beginning.value[3] = this.slots;
    uniforms.farol_firstNumber.value = step.first % WORDS;
    uniforms.farol_stepTimes.value.set(seconds, step.offset, step.interval);
    const onMesh = shape.kind === 'mesh' && shape.mesh !== null;
    const isLocal = space === 'local';
    // new particles move with the emitter during the step, so they begin at its transform at the step's end
    uniforms.farol_emitterStart.value.copy(onMesh ? shape.mesh.matrixWorld : isLocal ? matrix : start);
    uniforms.farol_emitterEnd.value.copy(onMesh ? shape.mesh.matrixWorld : matrix);
    const carried = uniforms.farol_carried.value.identity();
    // a scale of 0 has no inverse: particles then stay where they are
    if (isLocal && start.determinant() !== 0) carried.copy(start).invert().premultiply(matrix);
    from.setFromMatrixPosition(isLocal ? matrix : start);
    to.setFromMatrixPosition(matrix);
    uniforms.farol_inherited.value.subVectors(to, from).multiplyScalar(inheritVelocity / seconds);
    uniforms.farol_noise.value.z = emitter.noiseScroll * step.time;
    uniforms.farol_particlePositions.value = now.textures[0];
    uniforms.farol_particleVelocities.value = now.textures[1];
    pass.drawTo(frame, next);
    this.particles![0] = next;
    this.particles![1] = now;
  }

  private materialFor(frame: Frame): OutputMaterial {
    const { render, blending, lit, texture, softness } = this.emitter;
    const look = `${render} ${blending} ${lit} ${texture !== null} ${softness > 0}`;
    if (this.material === null || this.partsKey !== look) {
      this.dropMaterials();
      const sorted = blending !== 'additive';
      const parts = { render, blending, lit, map: texture !== null, soft: softness > 0, sorted };
      this.parts = parts;
      this.material = particleMaterial(frame, parts, this.uniforms);
      this.partsKey = look;
    }
    return this.material;
  }
}
