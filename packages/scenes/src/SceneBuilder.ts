import type { FieldValue, Vector3Tuple } from '@farol/editing/fields';
import {
  Camera,
  type ComponentClass,
  createRandom,
  GameObject,
  KeyController,
  Light,
  lightShadows,
  meshShadows,
  MouseController,
  ObjectRenderer,
  RandomMovement,
  Scene,
} from '@farol/engine';
import { hueColour } from './hueColour';
import type { SceneBuildOptions } from './SceneDefinition';

type Values = Readonly<Record<string, FieldValue>>;

interface Placement {
  position?: Vector3Tuple;
  rotation?: Vector3Tuple;
  scale?: Vector3Tuple;
  parent?: GameObject;
}

interface MovingLight {
  position: Vector3Tuple;
  /** Luminous intensity (cd). */
  intensity: number;
  /** Distance beyond which the light has no effect (m). */
  range: number;
  extent: Vector3Tuple;
  speed: number;
  /** Whether the light casts shadows, in maps of 512 × 512 texels. */
  castShadow?: boolean;
}

const OWN = 2654435761;

/** Builds a scene with ids that depend on the order of calls alone, so that equal scenes give equal files. */
export class SceneBuilder {
  readonly scene: Scene;
  readonly random: () => number;

  private readonly counts = new Map<string, number>();
  private readonly seed: number;
  /** Whether meshes and lights cast shadows. */
  private readonly shadows: boolean;

  constructor(name: string, options: SceneBuildOptions = {}) {
    this.seed = options.seed ?? 1;
    this.shadows = options.shadows ?? false;
    this.scene = new Scene({ name, assets: options.assets });
    this.random = createRandom(this.seed);
  }

  /** Adds an object with components, `[class, values]` each. */
  object(name: string, place: Placement, ...components: [ComponentClass, Values?][]): GameObject {
    const gameObject = new GameObject(name, { id: this.id(name) });
    for (const key of ['position', 'rotation', 'scale'] as const) {
      if (place[key]) gameObject.transform[key] = place[key];
    }
    for (const [type, values] of components) gameObject.addComponent(type, values);
    (place.parent ?? this.scene).add(gameObject);
    return gameObject;
  }

  /** Adds an object without components, as parent of other objects. */
  group(name: string, parent?: GameObject): GameObject {
    return this.object(name, { parent });
  }

  mesh(name: string, mesh: string, values: Values, place: Placement = {}): GameObject {
    return this.object(name, place, [ObjectRenderer, { mesh, ...(this.shadows && meshShadows), ...values }]);
  }

  /** Adds the camera, which the keys W, A, S, D, E and Q move (`speed`: m/s) and dragging turns. */
  camera(position: Vector3Tuple, target: Vector3Tuple, values: Values = {}, speed = 5): GameObject {
    const camera = this.object('Camera', {}, [Camera, values], [KeyController, { speed }], [MouseController]);
    camera.transform.lookAt(position, target);
    return camera;
  }

  /** Adds a light that shines from `position` to `target`. */
  light(name: string, values: Values, position: Vector3Tuple, target?: Vector3Tuple, parent?: GameObject): GameObject {
    const { type } = values;
    const casts = this.shadows && (type === 'directional' || type === 'spot');
    const light = this.object(name, { position, parent }, [Light, { ...(casts && lightShadows[type]), ...values }]);
    if (target) light.transform.lookAt(position, target);
    return light;
  }

  /**
   * Adds `count` moving point lights of many hues. Light i depends only on the seed and i, so that a scene with more
   * lights contains those of a scene with fewer, unless `describe` depends on the count.
   */
  movingLights(count: number, parent: GameObject, describe: (i: number, random: () => number) => MovingLight): void {
    for (let i = 0; i < count; i++) {
      const random = createRandom(Math.imul(this.seed, OWN) + 7919 * (i + 1));
      const diffuse = hueColour(random());
      const { position, intensity, range, extent, speed, castShadow = false } = describe(i, random);
      const seed = Math.floor(random() * 2 ** 31);
      this.object(
        'Light',
        { position, parent },
        [Light, { diffuse, intensity, range, ...(castShadow && { castShadow, shadowMapSize: 512 }) }],
        [ObjectRenderer, { mesh: 'bulb', kind: 'basic', colour: diffuse, instanced: true }],
        [RandomMovement, { seed, extent, speed }],
      );
    }
  }

  private id(name: string): string {
    const base = name.toLowerCase().replaceAll(/[^a-z0-9]+/g, '-');
    const count = (this.counts.get(base) ?? 0) + 1;
    this.counts.set(base, count);
    return `${base}-${count}`;
  }
}
