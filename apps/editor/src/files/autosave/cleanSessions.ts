const KEY = 'farol-autosave-clean';

const read = (): string[] => {
  try {
    const sessions: unknown = JSON.parse(localStorage.getItem(KEY) ?? '[]');
    return Array.isArray(sessions) ? (sessions as string[]) : [];
  } catch {
    return [];
  }
};

/** Notes that a session was left with nothing unsaved. It is written at once: a page on its way out waits for no worker. */
export function noteClean(session: string): void {
  try {
    localStorage.setItem(KEY, JSON.stringify([...read().slice(-20), session]));
  } catch {
    // no room: the session is offered once more
  }
}

/** The sessions that were left so; they are forgotten here. */
export function takeClean(): ReadonlySet<string> {
  const sessions = new Set(read());
  try {
    localStorage.removeItem(KEY);
  } catch {
    // a page that may store nothing
  }
  return sessions;
}
