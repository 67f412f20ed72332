import { audioOutput } from '@farol/engine';
import { useSyncExternalStore } from 'react';

const subscribe = (listener: () => void): (() => void) => audioOutput.onChange(listener);

/** Whether a sound waits for the user's first press. */
export const useSoundWaits = (): boolean => useSyncExternalStore(subscribe, () => audioOutput.isWaiting);
