import { Scene } from 'three';

/** The three scene of a Scene: notifies listeners when three has updated its world matrices. */
export class SceneRoot extends Scene {
  private readonly listeners: (() => void)[] = [];

  override updateMatrixWorld(force?: boolean): void {
    super.updateMatrixWorld(force);
    for (let i = 0; i < this.listeners.length; i++) this.listeners[i]();
  }

  /** Calls `listener` after each update. @returns a function that removes the listener */
  onMatricesUpdated(listener: () => void): () => void {
    this.listeners.push(listener);
    return () => {
      const place = this.listeners.indexOf(listener);
      if (place >= 0) this.listeners.splice(place, 1);
    };
  }
}
