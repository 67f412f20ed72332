/** The command that installs the other engines. */
export const installCommand = 'npm run rivals';

/** Installed versions of the other engines. */
export interface InstalledRivals {
  /** Versions of the engines' packages by the competitor's key; empty if they are not installed. */
  readonly versions: Readonly<Record<string, string>>;
  /** Whether the page's server can install competitors, as that of `npm start` can. */
  readonly canInstall: boolean;
}

/** Asks the page's server for the installed versions of the other engines. */
export async function installedRivals(): Promise<InstalledRivals> {
  try {
    const answer = await fetch(new URL('rivals/versions.json', document.baseURI));
    if (answer.ok) return (await answer.json()) as InstalledRivals;
  } catch {
    // the server cannot be reached, or its answer is not JSON: no engine counts as installed
  }
  return { versions: {}, canInstall: false };
}

/**
 * Makes the server of `npm start` install the other engines, which takes seconds to minutes.
 * @throws Error (as a rejection) with npm's message, or if the server cannot install
 */
export async function installRivals(): Promise<void> {
  const answer = await fetch(new URL('rivals/install', document.baseURI), { method: 'POST' });
  if (!answer.ok) throw new Error(`This server installs nothing: run ${installCommand}.`);
  const { problem } = (await answer.json()) as { problem: string | null };
  if (problem !== null) throw new Error(`The other engines were not installed: ${problem}`);
}
