import { createJSONStorage, type PersistStorage, type StateStorage } from 'zustand/middleware';

const attempt = <T>(run: () => T): T | null => {
  try {
    return run();
  } catch {
    return null;
  }
};

const storage: StateStorage = {
  getItem: (name) => attempt(() => localStorage.getItem(name)),
  setItem: (name, value) => void attempt(() => localStorage.setItem(name, value)),
  removeItem: (name) => void attempt(() => localStorage.removeItem(name)),
};

/** Stores settings in localStorage; without storage, or when it is full, they last until the page is closed. */
export const keptInBrowser = <S>(): PersistStorage<S> | undefined => createJSONStorage<S>(() => storage);
