import type { FieldTable } from '@farol/editing/fields';
import type { Scene } from '../core/Scene';
import { type ComponentBase, component } from '../core/Component';
import { PhysicsSystem } from './PhysicsSystem';

/**
 * The base class of a component that takes part in the physics of its scene, with these fields: it notifies the
 * PhysicsSystem when it is added, removed, switched on or off, or changed. Overrides of its methods must call `super`.
 * @throws Error as `component` does
 */
export function physicsComponent<const F extends FieldTable>(fields: F): ComponentBase<F> {
  abstract class PhysicsComponent extends (component(fields) as unknown as ComponentBase<Record<never, never>>) {
    override onEnterScene(scene: Scene): void {
      scene.system(PhysicsSystem).componentChanged(this);
    }

    override onLeaveScene(scene: Scene): void {
      scene.system(PhysicsSystem).componentChanged(this);
    }

    override onFieldChanged(_name: string): void {
      this.scene?.system(PhysicsSystem).componentChanged(this);
    }

    override onActiveChanged(): void {
      this.scene?.system(PhysicsSystem).componentChanged(this);
    }
  }
  return PhysicsComponent as never;
}
