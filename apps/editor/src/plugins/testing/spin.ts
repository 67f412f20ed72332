import { component, number } from '@farol/engine/fields';
import type { EditorPlugin } from '../../api/EditorPlugin';

class Spin extends component({ rate: number(1, { unit: 'rad/s', help: 'How fast it turns.' }) }) {
  static override readonly typeName: string = 'Spin';
  static override readonly help: string = 'Turns round its own axis while the scene plays.';

  override update(deltaSeconds: number): void {
    this.gameObject.object3D.rotateY(this.rate * deltaSeconds);
  }
}

export const spin: EditorPlugin = { name: 'Spin', components: [Spin] };
