import type { FieldTable } from '@farol/editing/fields';
import type { BufferGeometry } from 'three';
import { type Component, type ComponentBase, component } from '../core/Component';
import type { ShapeSource } from '../core/ShapeSource';
import { meshShadows } from './newShadows';
import { ObjectRenderer } from './ObjectRenderer';

/** The component that draws the shape of a new object. */
export const drawnShape = [ObjectRenderer, { mesh: null, ...meshShadows }] as const;

/** Options of fields that are lengths, and of those that are sizes. */
export const metres = { unit: 'm', step: 0.05 };
export const size = { ...metres, min: 0.01 };

/** A component that makes the shape of its object of its fields. */
export interface ShapeMaker extends Component, ShapeSource {
  /** @internal */
  makeShape(): BufferGeometry;
}

/**
 * The base class of a component that shapes its object by these fields: geometry is made when it is first asked for after
 * a change, and the ObjectRenderer that draws it is notified.
 * @throws Error as `component` does
 */
export function shapeComponent<const F extends FieldTable>(fields: F): ComponentBase<F, ShapeMaker> {
  abstract class ShapeComponent extends (component(fields) as unknown as ComponentBase<Record<never, never>>) {
    private made: BufferGeometry | null = null;
    private isGone = false;

    abstract makeShape(): BufferGeometry;

    get shapeGeometry(): BufferGeometry | null {
      return this.isGone ? null : (this.made ??= this.makeShape());
    }

    override onAttach(): void {
      this.isGone = false;
      this.tellRenderer();
    }

    override onDetach(): void {
      this.isGone = true;
      this.tellRenderer();
    }

    override onActiveChanged(): void {
      this.tellRenderer();
    }

    override onFieldChanged(_name: string): void {
      this.made = null;
      this.tellRenderer();
    }

    private tellRenderer(): void {
      this.gameObject.getComponent(ObjectRenderer)?.shapeChanged();
    }
  }
  return ShapeComponent as never;
}
