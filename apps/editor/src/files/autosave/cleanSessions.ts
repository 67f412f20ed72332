const KEY = 'farol-autosave-clean';

const read = (): string[] => {
  try {
    const sessions: unknown = JSON.parse(localStorage.getItem(KEY) ?? '[]');
    return Array.isArray(sessions) ? (sessions as string[]) : [];
  } catch {
    return [];
  }
};

/**
 * Notes that a session ended with nothing unsaved. In localStorage, which is synchronous: a closing page cannot wait
 * for a worker.
 */
export function noteClean(session: string): void {
  try {
    localStorage.setItem(KEY, JSON.stringify([...read().slice(-20), session]));
  } catch {
    // storage is full: the session is offered for recovery once more
  }
}

/** Ids of sessions that ended with nothing unsaved; each is returned once. */
export function takeClean(): ReadonlySet<string> {
  const sessions = new Set(read());
  try {
    localStorage.removeItem(KEY);
  } catch {
    // the browser forbids storage: there are no sessions
  }
  return sessions;
}
