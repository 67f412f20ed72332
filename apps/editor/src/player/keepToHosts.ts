/** Restricts the page, including workers, to fetching from its own and the given hosts; it can show no other page. */
export function keepToHosts(hosts: readonly string[]): void {
  const policy = document.createElement('meta');
  policy.httpEquiv = 'Content-Security-Policy';
  const allowed = hosts.filter((host) => /^https?:\/\/[\w.:[\]-]+$/.test(host));
  policy.content = `connect-src 'self' data: blob: ${allowed.join(' ')}; frame-src 'none'`;
  document.head.append(policy);
  // removed, since no content policy covers these connections
  for (const name of ['RTCPeerConnection', 'webkitRTCPeerConnection']) Reflect.deleteProperty(globalThis, name);
}
