import { classNameOf, isJavaScript } from './scriptNames';

/** Text of a new script: a component class with one field. */
export function scriptTemplate(script: string): string {
  const typed = (text: string): string => (isJavaScript(script) ? '' : text);
  return `import { component, number } from '@farol/engine/fields';

/** Turns its object while the scene plays. */
export default class ${classNameOf(script)} extends component({
  speed: number(1, { unit: 'rad/s', help: 'How fast it turns.' }),
}) {
  /** Once, before the first update. */
  ${typed('override ')}start()${typed(': void')} {}

  /** Each frame; deltaSeconds is the time since the last one. */
  ${typed('override ')}update(deltaSeconds${typed(': number')})${typed(': void')} {
    this.gameObject.object3D.rotateY(this.speed * deltaSeconds);
  }
}
`;
}
