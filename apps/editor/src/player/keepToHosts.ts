/** From here on the page fetches from itself and these hosts alone, in workers too, and shows no other page. */
export function keepToHosts(hosts: readonly string[]): void {
  const policy = document.createElement('meta');
  policy.httpEquiv = 'Content-Security-Policy';
  const allowed = hosts.filter((host) => /^https?:\/\/[\w.:[\]-]+$/.test(host));
  policy.content = `connect-src 'self' data: blob: ${allowed.join(' ')}; frame-src 'none'`;
  document.head.append(policy);
  // no policy is about these connections, which name their hosts themselves
  for (const name of ['RTCPeerConnection', 'webkitRTCPeerConnection']) Reflect.deleteProperty(globalThis, name);
}
