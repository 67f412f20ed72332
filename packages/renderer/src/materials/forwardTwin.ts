import { BackSide, FrontSide } from 'three';
import type { View } from '../debug/views';
import { litTwin } from './litTwin';
import type { TwinKind } from './TwinKind';

const AT_END: Partial<Record<View, string>> = {
  lighting: 'gl_FragColor.rgb = reflectedLight.directDiffuse + reflectedLight.directSpecular;',
  'light-count': 'gl_FragColor = vec4(farol_heatMap(farol_lightsEvaluated * farol_heatScale), 1.0);',
};

/** The three sides of one forward kind: as the source has it, and the two halves of a transparent double-sided draw. */
export interface ForwardTwins {
  readonly whole: TwinKind;
  readonly back: TwinKind;
  readonly front: TwinKind;
}

/**
 * Lit materials shaded in one draw by all lights that the loop visits.
 * @param adapt makes of each kind what is used in its place
 */
export function forwardTwins(loop: string, adapt = (kind: TwinKind): TwinKind => kind): (view: View) => ForwardTwins {
  const made = new Map<string, ForwardTwins>();
  return (view) => {
    const atEnd = AT_END[view];
    const mode = atEnd === undefined ? 'final' : view;
    let twins = made.get(mode);
    if (twins === undefined) {
      const kind = (part: string, properties?: TwinKind['properties']) =>
        adapt(
          litTwin({
            key: `forward-${loop}-${mode}${part}`,
            loop,
            ...(mode === 'light-count' && { chunks: ['heatMap', 'heatScale'] }),
            ...(atEnd !== undefined && { atEnd }),
            ...(properties && { properties }),
          }),
        );
      twins = { whole: kind(''), back: kind('-back', { side: BackSide }), front: kind('-front', { side: FrontSide }) };
      made.set(mode, twins);
    }
    return twins;
  };
}
