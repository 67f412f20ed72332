import { useCallback, useEffect, useState } from 'preact/hooks';
import type { Configuration } from '../../plan/Configuration';
import { presets } from '../../plan/presets';
import { configurationOf, linkOf } from '../../results/link';

export interface ConfigurationState {
  readonly configuration: Configuration;
  /** What could not be read of the address, as sentences. */
  readonly problems: readonly string[];
  /** Takes another configuration, also into the address. */
  setConfiguration(configuration: Configuration): void;
}

/** The configuration in the address; Quick where the address says none. */
export function useConfiguration(): ConfigurationState {
  const [state, setState] = useState(readAddress);
  useEffect(() => {
    const read = (): void => setState(readAddress());
    addEventListener('hashchange', read);
    return () => removeEventListener('hashchange', read);
  }, []);
  const setConfiguration = useCallback((configuration: Configuration) => {
    // no entry in the history for each letter
    history.replaceState(null, '', linkOf(configuration));
    setState({ configuration, problems: [] });
  }, []);
  return { ...state, setConfiguration };
}

function readAddress(): { configuration: Configuration; problems: readonly string[] } {
  return configurationOf(location.hash) ?? { configuration: presets.quick.configuration, problems: [] };
}
