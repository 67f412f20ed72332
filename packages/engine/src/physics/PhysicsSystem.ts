import type { Component } from '../core/Component';
import type { Scene } from '../core/Scene';
import type { SceneSystem } from '../core/SceneSystem';
import { loadRapier } from './loadRapier';
import type { PhysicsWorld } from './PhysicsWorld';

type Code = {
  readonly start: (scene: Scene, system: PhysicsSystem) => PhysicsWorld;
  shapesReady(scene: Scene): Promise<void>;
};

/** Types of components for which a scene needs physics. */
const types = ['RigidBody', 'Collider', 'CharacterController', 'Joint'] as const;

/** Fetches Rapier and the physics code, which are late code. */
async function loadCode(): Promise<Code> {
  const [rapier, { PhysicsWorld }, { shapesReady }] = await Promise.all([
    loadRapier(),
    import('./PhysicsWorld'),
    import('./meshParts'),
  ]);
  return { start: (scene, system) => new PhysicsWorld(rapier, scene, system), shapesReady };
}

/**
 * The physics of a scene. Its world is created when the scene is first simulated, advances in steps of 1/60 s, and is
 * discarded when the scene is reset. It starts once the code and all collider meshes are loaded, always with the same
 * first step, so the same scene moves the same way in every run.
 */
export class PhysicsSystem implements SceneSystem {
  readonly order = 200;
  /** Components whose fields changed while the physics world exists. */
  readonly changed = new Set<Component>();
  /** Counter, raised when physics components were added, removed or changed. */
  revision = 0;

  private world: PhysicsWorld | null = null;
  private code: Code | null = null;
  private preparing: Promise<void> | null = null;
  private isReady = false;
  private failure: unknown = null;
  private isFailureTold = false;

  constructor(private readonly scene: Scene) {}

  /** Whether code and collider meshes are loaded, so that the next update simulates. */
  get ready(): boolean {
    return this.isReady;
  }

  /** Number of steps of 1/60 s simulated since the scene was reset. */
  get steps(): number {
    return this.world?.steps ?? 0;
  }

  /** Duration (ms) of Rapier's steps and of the whole last update, for measurements. */
  get times(): { readonly rapier: number; readonly all: number } {
    return this.world?.times ?? { rapier: 0, all: 0 };
  }

  /**
   * Fetches Rapier and the meshes of colliders, so that playing begins with physics in the first frame.
   * @throws Error (as a rejection) when the code cannot be fetched
   */
  prepare(): Promise<void> {
    this.preparing ??= this.fetchAll().catch((error: unknown) => {
      this.preparing = null;
      throw error;
    });
    return this.preparing;
  }

  /** Records a component that was added, removed, switched on or off, or changed, for the next update of the world. */
  componentChanged(component: Component): void {
    this.revision++;
    if (this.world) this.changed.add(component);
    else if (this.isReady) {
      // a collider may name a mesh that is not loaded yet
      this.isReady = false;
      this.preparing = null;
    }
  }

  update(deltaSeconds: number): void {
    if (deltaSeconds <= 0) return;
    if (!this.world) {
      if (!this.isNeeded) return;
      if (!this.isReady) {
        if (this.failure === null) this.prepare().catch((error: unknown) => (this.failure = error));
        else this.tellFailure();
        return;
      }
      this.world = this.code!.start(this.scene, this);
    }
    this.world.update(deltaSeconds);
  }

  reset(): void {
    this.world?.dispose();
    this.world = null;
    this.changed.clear();
    this.failure = null;
    this.isFailureTold = false;
  }

  dispose(): void {
    this.reset();
  }

  private get isNeeded(): boolean {
    return types.some((type) => this.scene.componentsOf(type).length > 0);
  }

  private async fetchAll(): Promise<void> {
    this.code ??= await loadCode();
    let seen = -1;
    // waits also for components that were added meanwhile
    while (seen !== this.revision) {
      seen = this.revision;
      await this.code.shapesReady(this.scene);
    }
    this.isReady = true;
  }

  /** Reports the failed fetch once, through the first component; the next play tries again. */
  private tellFailure(): void {
    if (this.isFailureTold) return;
    this.isFailureTold = true;
    const reason = this.failure instanceof Error ? this.failure.message : String(this.failure);
    const type = types.find((each) => this.scene.componentsOf(each).length > 0);
    if (!type) return;
    const [component] = this.scene.componentsOf(type);
    this.scene.reportError(
      component,
      new Error(`Physics could not be fetched: ${reason} Check the connection and play again.`),
    );
  }
}
