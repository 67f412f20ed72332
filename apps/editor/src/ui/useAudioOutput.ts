import { audioOutput } from '@farol/engine';
import { useSyncExternalStore } from 'react';

const subscribe = (listener: () => void): (() => void) => audioOutput.onChange(listener);

/** Whether a sound waits for the user's first interaction with the page, as browsers require. */
export const useSoundWaits = (): boolean => useSyncExternalStore(subscribe, () => audioOutput.isWaiting);
