/* SPDX-License-Identifier: BSD-3-Clause */
/* The names under which Abaqus and its kin look for user subroutines, in front of libBARRENO.so. Not part of that
 * library, where they would clash with a host's own. Compile it with the job and link the library:
 *
 *   abaqus job=JOB user=abaqus_entry.c      with -L.../lib -lBARRENO in link_sl of abaqus_v6.env
 *   cc -shared -fPIC abaqus_entry.c -L.../lib -lBARRENO -o libumat.so
 *
 * For a host that wants another name: -DBARRENO_VUMAT_NAME=rock_vumat_. Arguments are handed on as they come. */
#ifndef BARRENO_UMAT_NAME
#define BARRENO_UMAT_NAME umat_
#endif
#ifndef BARRENO_VUMAT_NAME
#define BARRENO_VUMAT_NAME vumat_
#endif

typedef void* P;

void UMAT(
    P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P,
    P, P, P, P, P, P);
void VUMAT(
    P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P, P,
    P, P);

void BARRENO_UMAT_NAME(
    P a1, P a2, P a3, P a4, P a5, P a6, P a7, P a8, P a9, P a10, P a11, P a12, P a13, P a14, P
    a15, P a16, P a17, P a18, P a19, P a20, P a21, P a22, P a23, P a24, P a25, P a26, P a27, P
    a28, P a29, P a30, P a31, P a32, P a33, P a34, P a35, P a36, P a37) {
  UMAT(
    a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20,
    a21, a22, a23, a24, a25, a26, a27, a28, a29, a30, a31, a32, a33, a34, a35, a36, a37);
}

void BARRENO_VUMAT_NAME(
    P a1, P a2, P a3, P a4, P a5, P a6, P a7, P a8, P a9, P a10, P a11, P a12, P a13, P a14, P
    a15, P a16, P a17, P a18, P a19, P a20, P a21, P a22, P a23, P a24, P a25, P a26, P a27, P
    a28, P a29, P a30, P a31, P a32, P a33) {
  VUMAT(
    a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20,
    a21, a22, a23, a24, a25, a26, a27, a28, a29, a30, a31, a32, a33);
}
