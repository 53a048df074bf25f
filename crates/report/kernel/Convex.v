(* Polygons, in integers: left turns within half a turn make every generator keep every side. *)
From Coq Require Import ZArith List Bool Lia.
From Boundfit Require Import Reader Checker.
Import ListNotations.
Local Open Scope Z_scope.

Lemma cancel a b : 0 < a -> 0 <= a * b -> 0 <= b.
Proof. intros. apply (Z.mul_le_mono_pos_l 0 b a); lia. Qed.

Ltac open_triples := unfold det, dot, cross, turn, times, plus, opposite, infinity, across in *; cbn [tx ty tw] in *.

(* Cramer's rule. *)
Lemma cramer s a b c p :
  det a b c * dot s p = dot s a * det p b c + dot s b * det a p c + dot s c * det a b p.
Proof. open_triples; ring. Qed.

(* Five points: the relation of Grassmann and Pluecker with one of them in every determinant, in the three forms that a walk
   needs. *)
Lemma exchange o a b c d : det o b c * det a b d = det o a b * det b c d + det a b c * det o b d.
Proof. open_triples; ring. Qed.
Lemma swapped a b c : det a c b = - det a b c.
Proof. open_triples; ring. Qed.
Lemma turned a b c : det b c a = det a b c.
Proof. open_triples; ring. Qed.
Lemma exchange_back o a b c d : det o a b * det b c d = det o b c * det a b d + det a b c * det o d b.
Proof. pose proof (exchange o a b c d). rewrite (swapped o b d). lia. Qed.
Lemma exchange_first o a b c d : det o a c * det o b d = det o a b * det o c d + det o a d * det o b c.
Proof.
  pose proof (exchange b a o c d) as E. rewrite (turned c b o), (turned d a o), (turned c a o), (turned d b o) in E.
  rewrite !(turned o), (swapped o b c), (swapped o a d), (swapped o a c), (swapped o b d), (swapped o a b) in E. lia.
Qed.
Lemma repeated a b : det a b b = 0.
Proof. pose proof (swapped a b b). lia. Qed.

Section Walk.
  Local Open Scope nat_scope.
  Variables (g : nat -> triple) (k : nat).
  Definition X i j := det (g 0) (g i) (g j).
  Definition A i j l := det (g i) (g j) (g l).
  Hypothesis two : 2 <= k.
  Hypothesis fan : forall i, 1 <= i -> S i <= k -> (0 < X i (S i))%Z.
  Hypothesis within : forall j, 2 <= j -> j <= k -> (0 < X 1 j)%Z.
  Hypothesis left : forall i, 1 <= i -> S (S i) <= k -> (0 <= A i (S i) (S (S i)))%Z.

  Lemma ordered i j : 1 <= i -> i <= j -> j <= k -> (0 <= X i j)%Z.
  Proof.
    intros Hi Hij Hj. induction Hij as [| j Hij IH].
    - unfold X. now rewrite repeated.
    - destruct (Nat.eq_dec i 1) as [-> | Hne].
      + specialize (within (S j)). lia.
      + apply (cancel (X 1 j)); [apply within; lia |].
        replace (X 1 j * X i (S j))%Z with (X 1 i * X j (S j) + X 1 (S j) * X i j)%Z by (symmetry; apply exchange_first).
        pose proof (fan j) as H. pose proof (within i) as H0. pose proof (within (S j)) as H1.
        assert (0 <= X i j)%Z by (apply IH; lia). specialize (H ltac:(lia) ltac:(lia)).
        specialize (H0 ltac:(lia) ltac:(lia)). specialize (H1 ltac:(lia) ltac:(lia)). nia.
  Qed.

  Lemma forward d : forall i, 1 <= i -> S i + d <= k -> (0 <= A i (S i) (S i + d))%Z.
  Proof.
    induction d as [| d IH]; intros i Hi Hk.
    - rewrite Nat.add_0_r. unfold A. now rewrite repeated.
    - replace (S i + S d) with (S (S i) + d) in * by lia.
      apply (cancel (X (S i) (S (S i)))); [apply fan; lia |].
      replace (X (S i) (S (S i)) * A i (S i) (S (S i) + d))%Z with
        (X i (S i) * A (S i) (S (S i)) (S (S i) + d) + A i (S i) (S (S i)) * X (S i) (S (S i) + d))%Z
        by (symmetry; apply exchange).
      assert (0 < X i (S i))%Z by (apply fan; lia).
      assert (0 <= A (S i) (S (S i)) (S (S i) + d))%Z by (apply IH; lia).
      assert (0 <= A i (S i) (S (S i)))%Z by (apply left; lia).
      assert (0 <= X (S i) (S (S i) + d))%Z by (apply ordered; lia). nia.
  Qed.

  Lemma backward d : forall p, 1 <= p -> S (p + d) <= k -> (0 <= A (p + d) (S (p + d)) p)%Z.
  Proof.
    induction d as [| d IH]; intros p Hp Hk.
    - rewrite Nat.add_0_r. unfold A. now rewrite turned, turned, repeated.
    - replace (p + S d) with (S (p + d)) in * by lia.
      set (q := p + d) in *.
      apply (cancel (X q (S q))); [apply fan; lia |].
      replace (X q (S q) * A (S q) (S (S q)) p)%Z with
        (X (S q) (S (S q)) * A q (S q) p + A q (S q) (S (S q)) * X p (S q))%Z by (symmetry; apply exchange_back).
      assert (0 < X (S q) (S (S q)))%Z by (apply fan; lia).
      assert (0 <= A q (S q) p)%Z by (apply IH; lia).
      assert (0 <= A q (S q) (S (S q)))%Z by (apply left; lia).
      assert (0 <= X p (S q))%Z by (apply ordered; lia). nia.
  Qed.

  Lemma edge i j : 1 <= i -> S i <= k -> j <= k -> (0 <= A i (S i) j)%Z.
  Proof.
    intros Hi Hk Hj. destruct (Nat.eq_dec j 0) as [-> | Hne].
    - replace (A i (S i) 0) with (X i (S i)) by (symmetry; apply turned). specialize (fan i). lia.
    - destruct (Nat.le_gt_cases j i).
      + replace i with (j + (i - j)) by lia. apply backward; lia.
      + replace j with (S i + (j - S i)) by lia. apply forward; lia.
  Qed.

  (* Sides: s 0 through g 0 and g 1, ..., s k through g k and g 0. *)
  Variable s : nat -> triple.
  Hypothesis on_first : forall i, 1 <= i -> i < k -> dot (s i) (g i) = 0%Z.
  Hypothesis on_second : forall i, 1 <= i -> i < k -> dot (s i) (g (S i)) = 0%Z.
  Hypothesis inside : forall i, 1 <= i -> i < k -> (0 < dot (s i) (g 0))%Z.
  Hypothesis start : dot (s 0) (g 0) = 0%Z /\ dot (s 0) (g 1) = 0%Z /\ (0 < dot (s 0) (g 2))%Z.
  Hypothesis last : dot (s k) (g k) = 0%Z /\ dot (s k) (g 0) = 0%Z /\ (0 < dot (s k) (g (k - 1)))%Z.

  Theorem walk i j : i <= k -> j <= k -> (0 <= dot (s i) (g j))%Z.
  Proof.
    intros Hi Hj. destruct (Nat.eq_dec i 0) as [-> | Hi0].
    - destruct start as (A0 & A1 & A2). apply (cancel (det (g 0) (g 1) (g 2))); [apply (fan 1); lia |].
      rewrite (cramer (s 0) (g 0) (g 1) (g 2) (g j)), A0, A1.
      assert (0 <= X 1 j)%Z.
      { destruct (Nat.eq_dec j 0) as [-> |]; [unfold X; now rewrite turned, turned, repeated | apply ordered; lia]. }
      unfold X in *. nia.
    - destruct (Nat.eq_dec i k) as [-> | Hik].
      + destruct last as (A0 & A1 & A2). apply (cancel (det (g 0) (g (k - 1)) (g k))).
        { replace (g k) with (g (S (k - 1))) by (f_equal; lia). apply fan; lia. }
        rewrite (cramer (s k) (g 0) (g (k - 1)) (g k) (g j)), A0, A1.
        assert (0 <= X j k)%Z.
        { destruct (Nat.eq_dec j 0) as [-> |]; [unfold X; now rewrite turned, repeated | apply ordered; lia]. }
        unfold X in *. nia.
      + apply (cancel (det (g 0) (g i) (g (S i)))); [apply fan; lia |].
        rewrite (cramer (s i) (g 0) (g i) (g (S i)) (g j)), on_first, on_second by lia.
        assert (0 < dot (s i) (g 0))%Z by (apply inside; lia).
        assert (0 <= A i (S i) j)%Z by (apply edge; lia).
        replace (det (g j) (g i) (g (S i))) with (A i (S i) j) by apply turned. nia.
  Qed.
End Walk.

Ltac split_checks :=
  repeat match goal with
  | H : _ && _ = true |- _ => apply andb_prop in H; destruct H
  | H : (_ =? _) = true |- _ => apply Z.eqb_eq in H
  | H : (_ <? _) = true |- _ => apply Z.ltb_lt in H
  | H : (_ <=? _) = true |- _ => apply Z.leb_le in H
  end.

(* What the recursive check of a fan says of each place: the list is g1, g2, ... and the sides h1, h2, ... *)
Lemma rotated a b c : dot (cross b c) a = det a b c.
Proof. open_triples; ring. Qed.
Lemma fan_facts g0 n0 : forall rest sides q r, fan g0 n0 q r rest sides = true ->
  let l := r :: rest in
  length sides = length l /\
  (forall i, (S i < length l)%nat -> 0 < det g0 (nth i l q) (nth (S i) l q) /\ 0 < dot n0 (nth (S i) l q) /\
     dot (nth i sides q) (nth i l q) = 0 /\ dot (nth i sides q) (nth (S i) l q) = 0 /\ 0 < dot (nth i sides q) g0) /\
  (forall i, (S i < length l)%nat -> 0 <= det (nth i (q :: l) q) (nth i l q) (nth (S i) l q)) /\
  (let n := length rest in dot (nth n sides q) (nth n l q) = 0 /\ dot (nth n sides q) g0 = 0 /\ 0 < dot (nth n sides q) (nth n (q :: l) q)).
Proof.
  induction rest as [| s rest IH]; intros sides q r H l.
  - destruct sides as [| h [| h' sides]]; cbn in H; try discriminate. split_checks.
    subst l. cbn. repeat split; try lia; auto.
  - destruct sides as [| h sides]; cbn [fan] in H; try discriminate. cbv zeta in H. rewrite !rotated in H. split_checks.
    match goal with H : fan _ _ _ _ _ _ = true |- _ => apply IH in H; destruct H as (Hl & Hf & Ht & Hn) end.
    subst l. cbn zeta in *.
    (* the default element is r in the hypotheses and q in the goal: both lists are long enough *)
    assert (D : forall (l : list triple) i, (i < length l)%nat -> nth i l r = nth i l q) by (intros; now apply nth_indep).
    cbn [length] in *. split; [lia |]. split; [| split].
    + intros [| i] Hi; [now cbn |]. specialize (Hf i ltac:(lia)).
      change (nth (S i) (r :: s :: rest) q) with (nth i (s :: rest) q).
      change (nth (S (S i)) (r :: s :: rest) q) with (nth (S i) (s :: rest) q).
      change (nth (S i) (h :: sides) q) with (nth i sides q).
      rewrite <- (D (s :: rest) i), <- (D (s :: rest) (S i)), <- (D sides i) by (cbn [length]; lia). exact Hf.
    + intros [| i] Hi; [now cbn |]. specialize (Ht i ltac:(lia)).
      change (nth (S i) (q :: r :: s :: rest) q) with (nth i (r :: s :: rest) q).
      change (nth (S i) (r :: s :: rest) q) with (nth i (s :: rest) q).
      change (nth (S (S i)) (r :: s :: rest) q) with (nth (S i) (s :: rest) q).
      rewrite <- (D (r :: s :: rest) i), <- (D (s :: rest) i), <- (D (s :: rest) (S i)) by (cbn [length]; lia). exact Ht.
    + change (nth (S (length rest)) (h :: sides) q) with (nth (length rest) sides q).
      change (nth (S (length rest)) (r :: s :: rest) q) with (nth (length rest) (s :: rest) q).
      change (nth (S (length rest)) (q :: r :: s :: rest) q) with (nth (length rest) (r :: s :: rest) q).
      rewrite <- (D (r :: s :: rest)), <- (D (s :: rest)), <- (D sides) by (cbn [length]; lia). exact Hn.
Qed.

Theorem sides_keep gs sides : fan_of gs sides = true -> forall h g, In h sides -> In g gs -> 0 <= dot h g.
Proof.
  intros H h g Hh Hg.
  destruct gs as [| g0 [| g1 [| g2 rest]]]; try discriminate.
  destruct sides as [| h0 sides]; [discriminate |].
  cbn [fan_of] in H. split_checks.
  match goal with H : fan _ _ _ _ _ _ = true |- _ => apply fan_facts in H; destruct H as (Hl & Hf & Ht & Hn) end.
  cbn zeta in *.
  set (l := g1 :: g2 :: rest) in *.
  assert (Hlen : length l = S (length (g2 :: rest))) by reflexivity.
  apply (In_nth _ _ g0) in Hh. destruct Hh as (i & Hi & <-).
  apply (In_nth _ _ g0) in Hg. destruct Hg as (j & Hj & <-).
  change (g0 :: g1 :: g2 :: rest) with (g0 :: l) in *.
  cbn [length] in Hi, Hj, Hl.
  apply (walk (fun n => nth n (g0 :: l) g0) (length l)) with (s := fun n => nth n (h0 :: sides) g0); try (cbn [length]; lia).
  - rewrite Hlen. cbn [length]. lia.
  - intros [| n]; [lia |]. intros. apply (Hf n). rewrite Hlen in *. cbn [length] in *. lia.
  - intros [| [| n]]; try lia. intros. apply (Hf n). rewrite Hlen in *. cbn [length] in *. lia.
  - intros [| n]; [lia |]. intros. apply (Ht (S n)). rewrite Hlen in *. cbn [length] in *. lia.
  - intros [| n]; [lia |]. intros. apply (Hf n). rewrite Hlen in *. cbn [length] in *. lia.
  - intros [| n]; [lia |]. intros. apply (Hf n). rewrite Hlen in *. cbn [length] in *. lia.
  - intros [| n]; [lia |]. intros. apply (Hf n). rewrite Hlen in *. cbn [length] in *. lia.
  - cbn. auto.
  - rewrite Hlen in *. cbn [length] in *.
    replace (S (S (length rest)) - 1)%nat with (S (length rest)) by lia. exact Hn.
Qed.
