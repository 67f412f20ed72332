import { BackSide, FrontSide } from 'three';
import { litTwin } from './litTwin';
import type { TwinKind } from './TwinKind';
import type { LightLoop } from './LightLoop';

const OPAQUE = '#include <opaque_fragment>';
const DIRECT_LIGHT = 'reflectedLight.directDiffuse + reflectedLight.directSpecular;';

/** Rewrites a shader to output only direct light, with tone mapping, colour space and fog. */
function onlyDirect(text: string): string {
  return text.replace(OPAQUE, `outgoingLight = ${DIRECT_LIGHT}\n${OPAQUE}`);
}

const COUNT = 'gl_FragColor = vec4(farol_heatMap(farol_lightsEvaluated * farol_heatScale), 1.0);';

/** Variants of a forward kind by side: the source's own side, and back and front of a transparent double-sided draw. */
export interface ForwardTwins {
  readonly whole: TwinKind;
  readonly back: TwinKind;
  readonly front: TwinKind;
}

/**
 * Twins of lit materials, shaded in one draw by all lights of a loop.
 * @param adapt - returns the replacement of each kind
 * @returns function that returns the twins of a view; views other than 'lighting' and 'light-count' have those of the final
 *   picture
 */
export function forwardTwins(
  loop: LightLoop,
  adapt = (kind: TwinKind): TwinKind => kind,
): (view: string) => ForwardTwins {
  const made = new Map<string, ForwardTwins>();
  return (view) => {
    const mode = view === 'lighting' || view === 'light-count' ? view : 'final';
    let twins = made.get(mode);
    if (twins === undefined) {
      const kind = (part: string, properties?: TwinKind['properties']) =>
        adapt(
          litTwin({
            key: `forward-${loop}-${mode}${part}`,
            role: 'forward',
            loop,
            ...(mode === 'light-count' && { oneByOne: true, chunks: ['heatMap', 'heatScale'], atEnd: COUNT }),
            ...(mode === 'lighting' && { rewrite: onlyDirect }),
            ...(properties && { properties }),
          }),
        );
      twins = { whole: kind(''), back: kind('-back', { side: BackSide }), front: kind('-front', { side: FrontSide }) };
      made.set(mode, twins);
    }
    return twins;
  };
}
