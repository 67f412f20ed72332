/**
 * Awaits code that imports a package which the host need not have installed.
 * @param use - subject and verb of the message: 'Scripts need'
 * @throws Error (as a rejection) that names the package and says how to install it, when the code cannot be loaded
 */
export function needsPackage<Code>(name: string, use: string, code: Promise<Code>): Promise<Code> {
  return code.catch((cause: unknown) => {
    throw new Error(
      `${use} the package ${name}, which cannot be loaded; install it (npm install ${name}), or serve its files with the page.`,
      { cause },
    );
  });
}
