/** Message of an error. Errors thrown in an iframe are no instances of this page's Error. */
export function messageOf(error: unknown): string {
  const message = typeof error === 'object' && error !== null && 'message' in error ? error.message : error;
  return typeof message === 'string' && message !== '' ? message : String(error);
}
