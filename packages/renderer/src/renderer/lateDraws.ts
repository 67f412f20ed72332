import type { LateDraws } from '../frame/Frame';
import type { MicroShaderRegistry } from '../microshaders';
import { addMicroShaders } from '../microshaders/addMicroShaders';
import { gouraudCode, nodeCode } from './lazyCode';

/** Fetches the code of twins and draws when a frame needs it. @param microshaders - registry that gets its microshaders */
export function lateDraws(microshaders: MicroShaderRegistry): LateDraws {
  return {
    gouraudTwins: (view) =>
      gouraudCode.use((code) => {
        addMicroShaders(microshaders, 'gouraud', code.microShaders);
        return code.gouraudTwins(view);
      }),
    makeNodes: () => nodeCode.use((code) => new code.NodeDraws()),
  };
}
