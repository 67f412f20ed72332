import type { BufferGeometry, Mesh, Texture } from 'three';
import type { LinearRGB } from '../../lights/lightData';

/** A key of a curve: time (0 to 1, ascending) and value; linear between keys, constant before the first and after the last. */
export type CurveKey = readonly [time: number, value: number];

/** A key of a gradient: time (0 to 1, ascending), linear colour, and opacity (0 to 1). */
export type GradientKey = readonly [time: number, color: LinearRGB, opacity: number];

/**
 * Region in which particles begin; lengths in metres, in the emitter's space. From a point or a sphere they move outwards, else
 * along +Y.
 */
export type EmitterShape =
  | { readonly kind: 'point' }
  /** `thickness` 0: from the surface; 1: from the whole volume. */
  | { readonly kind: 'sphere'; readonly radius: number; readonly thickness: number }
  /** Opens along +Y from a disc; `angle`: of the side to the axis (rad, 0 to π/2). */
  | { readonly kind: 'cone'; readonly radius: number; readonly angle: number }
  | { readonly kind: 'box'; readonly size: readonly [number, number, number] }
  /**
   * Surface of a mesh at its place in the world, uniform by area, along its normals; without skinning and morphs. With `mesh`
   * null no particles begin.
   */
  | { readonly kind: 'mesh'; readonly mesh: Mesh | null };

/** A number of particles that begin at once. */
export interface ParticleBurst {
  /** Time after the start of the emitter, or of each of its loops (s). */
  readonly time: number;
  readonly count: number;
}

/** Obstacle that particles' centres bounce off: a plane, on the side of its normal, or a sphere, from outside. */
export type ParticleCollider = {
  /** Share of the speed towards the surface that is kept, 0 to 1. */
  readonly bounce: number;
  /** Share of the speed along the surface that is lost, 0 to 1. */
  readonly friction: number;
} & (
  | {
      readonly kind: 'plane';
      /** Normal of the plane, of any length but 0. */
      readonly normal: readonly [number, number, number];
      /** Distance of the plane from the origin along its normal (m). */
      readonly height: number;
    }
  | {
      readonly kind: 'sphere';
      /** Centre of the sphere (m). */
      readonly center: readonly [number, number, number];
      /** Radius of the sphere, above 0 (m). */
      readonly radius: number;
    }
);

/** Animation by a grid of pictures, played over a particle's life row by row from the top left. */
export interface FlipBook {
  readonly columns: number;
  readonly rows: number;
  /** Number of times that all pictures are shown in a life. Default 1. */
  readonly cycles?: number;
}

/**
 * Behaviour and look of the particles of a ParticleEmitter. SI units, radians, linear colours; world space unless stated
 * otherwise. Ranges `[least, most]` are sampled uniformly for each particle, by the seed.
 */
export interface ParticleSettings {
  /**
   * Maximum number of particles at once, 1 to 1,048,576; further ones do not begin. Each occupies its slot for the longest life,
   * so `rate` × longest life is enough. A change restarts the emitter. Default 1000.
   */
  capacity: number;
  /** Seed of all random numbers: equal seeds and steps give equal particles. Default 1. */
  seed: number;
  /** Particles that begin each second. Default 100. */
  rate: number;
  /** Groups of particles that begin at once. Default none. */
  bursts: readonly ParticleBurst[];
  /** Time before the first particle begins (s); `duration` and bursts begin after it; `prewarm` includes it. Default 0. */
  delay: number;
  /** Time during which the emitter emits (s); 0 for no end. Default 0. */
  duration: number;
  /** Whether the emitter starts again after `duration`. Default true. */
  loop: boolean;
  /** Time simulated in advance at the start and each restart, 0 to 60 s, so that particles are visible at once. Default 0. */
  prewarm: number;
  /** Region in which particles begin. A change restarts the emitter. Default a cone of 0.1 m and 0.35 rad. */
  shape: EmitterShape;
  /** Lifetime of a particle (s). Default [1, 2]. */
  life: readonly [number, number];
  /** Speed at the beginning (m/s). Default [1, 2]. */
  speed: readonly [number, number];
  /** Space of living particles: the world, or the emitter with its motion, rotation and scale. Default 'world'. */
  space: 'world' | 'local';
  /** Share of the emitter's own velocity that particles begin with, in the space 'world'. Default 0. */
  inheritVelocity: number;
  /** Acceleration (m/s²). Default [0, 0, 0]. */
  gravity: readonly [number, number, number];
  /** Drag (1/s), as in dv/dt = -drag · v. At least 0. Default 0. */
  drag: number;
  /** Acceleration by curl noise (m/s²). Default 0. */
  noiseStrength: number;
  /** Spatial frequency of the noise (1/m). Default 1. */
  noiseFrequency: number;
  /** Speed at which the noise moves down through the particles (m/s), so that it changes over time. Default 0. */
  noiseScroll: number;
  /** Obstacles, at most 4, tested in their order in each step. Default none. */
  colliders: readonly ParticleCollider[];
  /** Diameter of a particle (m), multiplied by `sizeOverLife`. Default [0.1, 0.2]. */
  size: readonly [number, number];
  /** Factor on the diameter over a particle's life (0 to 1). Default [[0, 1], [1, 1]]. */
  sizeOverLife: readonly CurveKey[];
  /** Colour and opacity over a particle's life. Default white, fading out. */
  colorOverLife: readonly GradientKey[];
  /** Factor on the colour, for particles brighter than white. Default 1. */
  brightness: number;
  /** Initial rotation (rad): for meshes about the axis of `orientation`, else in the picture plane. Default [0, 2π]. */
  initialRotation: readonly [number, number];
  /** Angular speed (rad/s), multiplied by `spinOverLife`. Default [0, 0]. */
  spin: readonly [number, number];
  /** Factor on the angular speed over a particle's life (0 to 1). Default [[0, 1], [1, 1]]. */
  spinOverLife: readonly CurveKey[];
  /** Picture of a particle, owned by the caller. Default null: a soft round dot. */
  texture: Texture | null;
  /** Animation by parts of `texture`. Default null: the whole texture. */
  flipBook: FlipBook | null;
  /**
   * Shape of a particle: faces the camera, is stretched along its velocity, or is `particleGeometry`. Default
   * 'billboard'.
   */
  render: 'billboard' | 'stretched' | 'mesh';
  /** Length of a stretched particle for each m/s of its speed (s). Default 0.05. */
  stretch: number;
  /**
   * Initial rotation of meshes: by `initialRotation` about a random axis for each, or about the mesh's +Y, which is then the
   * emitter's +Y or the direction of the particle's velocity. Default 'random'.
   */
  orientation: 'random' | 'emitter' | 'velocity';
  /**
   * Geometry of a particle for render 'mesh', of which 1 m is one diameter. Copied when set: the caller may draw, change or
   * dispose the original. Default null: nothing is drawn.
   */
  particleGeometry: BufferGeometry | null;
  /**
   * 'blended': alpha-blended, sorted back to front. 'additive': summed, in any order. 'weighted': by the effect
   * WeightedBlendedOIT if present, else 'blended'. Default 'additive'.
   */
  blending: 'blended' | 'additive' | 'weighted';
  /** Distance to a surface, and to the camera, within which a particle fades out (m); 0: hard edges. Default 0.2. */
  softness: number;
  /**
   * Whether all lights light particles, as rough white translucent balls (meshes: by their normals), times the particle's
   * colour: fully on the side towards a light, half at 90°, not on the far side. Light is computed once for each particle, at
   * its centre. Otherwise particles are emissive. Default false.
   */
  lit: boolean;
  /** Whether lit particles receive shadows. Default false. */
  receiveShadow: boolean;
  /** Every n-th particle is a point light; 0: none. Default 0. */
  lightEvery: number;
  /** Luminous intensity of each such light (cd), in the particle's colour, multiplied by its opacity. Default 1. */
  lightIntensity: number;
  /** Range of each such light (m), multiplied by `sizeOverLife`. Default 1. */
  lightRange: number;
}
