import { useCallback, useEffect, useState } from 'preact/hooks';
import type { Configuration } from '../../plan/Configuration';
import { presets } from '../../plan/presets';
import { configurationOf, linkOf } from '../../results/link';

export interface ConfigurationState {
  readonly configuration: Configuration;
  /** Errors of the address, each a sentence. */
  readonly problems: readonly string[];
  setConfiguration(configuration: Configuration): void;
}

/** Configuration of the address; the preset Quick if the address has none. */
export function useConfiguration(): ConfigurationState {
  const [state, setState] = useState(readAddress);
  useEffect(() => {
    const read = (): void => setState(readAddress());
    addEventListener('hashchange', read);
    return () => removeEventListener('hashchange', read);
  }, []);
  const setConfiguration = useCallback((configuration: Configuration) => {
    // the address is replaced, so that keystrokes do not add entries to the browser's history
    history.replaceState(null, '', linkOf(configuration));
    setState({ configuration, problems: [] });
  }, []);
  return { ...state, setConfiguration };
}

function readAddress(): { configuration: Configuration; problems: readonly string[] } {
  return configurationOf(location.hash) ?? { configuration: presets.quick.configuration, problems: [] };
}
