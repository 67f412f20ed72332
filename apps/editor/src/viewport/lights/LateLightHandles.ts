import { type GameObject, Light } from '@farol/engine';
import type { Scene } from 'three';
import type { Handle, HandleHost, HandlePoints } from '../handles/HandlePoints';

/** Colour of the lines of a selected light. */
const COLOUR = '#ff9d3c';
/** Distance kept from the light's origin, where its icon and the gizmo's centre are (CSS pixels). */
const CLEARANCE = 12;

/** Handles that size area lights; the code is fetched when one is first selected. */
export class LateLightHandles {
  /** The handles; null until their code is fetched. */
  points: HandlePoints | null = null;

  private isAsked = false;
  private isDisposed = false;

  /** @param helpers - the overlay scene */
  constructor(
    private readonly host: HandleHost,
    private readonly helpers: Scene,
    private readonly failed: (error: unknown) => void,
  ) {}

  /** Called before each frame. @param pixelRatio - pixel ratio of the canvas */
  update(pixelRatio: number): void {
    this.points?.update(pixelRatio);
    if (this.isAsked || !this.host.document.selectedObjects.some((object) => object.getComponent(Light)?.isArea))
      return;
    this.isAsked = true;
    Promise.all([import('../handles/HandlePoints'), import('./areaLightHandles')]).then(
      ([{ HandlePoints: Points }, { areaLightHandles }]) => {
        if (this.isDisposed) return;
        const handlesOf = (object: GameObject): Handle[] => {
          const light = object.getComponent(Light);
          return light?.isActive ? areaLightHandles(light) : [];
        };
        this.points = new Points(this.host, COLOUR, handlesOf, CLEARANCE);
        this.helpers.add(this.points.three);
        this.host.invalidate();
      },
      this.failed,
    );
  }

  dispose(): void {
    this.isDisposed = true;
    this.points?.dispose();
  }
}
