import type { BufferGeometry } from 'three';
import type { Component } from '../core/Component';
import { meshShadows } from './newShadows';
import { ObjectRenderer } from './ObjectRenderer';

/** The component that draws the shape of a new object. */
export const drawnShape = [ObjectRenderer, { mesh: null, ...meshShadows }] as const;

/** Geometry that a component makes of its fields; notifies the ObjectRenderer that draws it. */
export class OwnShape {
  private made: BufferGeometry | null = null;
  private isGone = false;

  constructor(
    private readonly component: Component,
    private readonly make: () => BufferGeometry,
  ) {}

  /** Geometry, computed lazily after a change; null once the component has left its object. */
  get geometry(): BufferGeometry | null {
    return this.isGone ? null : (this.made ??= this.make());
  }

  /**
   * Notifies the ObjectRenderer that the component was added, removed, switched on or off, or has changed fields.
   * @param change - 'fields' recomputes the geometry
   */
  tell(change: 'came' | 'gone' | 'switched' | 'fields'): void {
    if (change === 'fields') this.made = null;
    this.isGone = change === 'gone' || (this.isGone && change !== 'came');
    this.component.gameObject.getComponent(ObjectRenderer)?.shapeChanged();
  }
}
