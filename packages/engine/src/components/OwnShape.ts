import type { BufferGeometry } from 'three';
import type { Component } from '../core/Component';
import { ObjectRenderer } from './ObjectRenderer';

/** The geometry that a component makes of its fields, and the word to the ObjectRenderer that draws it. */
export class OwnShape {
  private made: BufferGeometry | null = null;
  private isGone = false;

  constructor(
    private readonly component: Component,
    private readonly make: () => BufferGeometry,
  ) {}

  /** Made when it is first asked for after a change; null once the component has left its object. */
  get geometry(): BufferGeometry | null {
    return this.isGone ? null : (this.made ??= this.make());
  }

  /** The component came, went, was switched, or its fields changed. @param change - 'fields' makes another shape */
  tell(change: 'came' | 'gone' | 'switched' | 'fields'): void {
    if (change === 'fields') this.made = null;
    this.isGone = change === 'gone' || (this.isGone && change !== 'came');
    this.component.gameObject.getComponent(ObjectRenderer)?.shapeChanged();
  }
}
